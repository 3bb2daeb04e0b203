#include "catch_compat.hpp"
#include "signorini/fem/stress.hpp"

using Eigen::Vector2d;
using Eigen::Vector3d;
using signorini::Traction;
using signorini::traction;

TEST_CASE("a pressed face has minus the pressure as normal stress, on both sides of it",
          "[traction][LinEtAl-5]") {
  const Vector3d uniform(-3, -3, 0);
  for (const Vector2d& normal : {Vector2d(0.6, 0.8), Vector2d(-0.6, -0.8), Vector2d(0, 1)}) {
    const Traction on = traction(uniform, normal);
    CHECK(on.normal == Approx(-3).epsilon(1e-15));
    CHECK(on.tangential.norm() < 1e-15);  // rounding of 0.6^2 + 0.8^2
  }
}

TEST_CASE("the two parts of a traction are at right angles and make up the whole",
          "[traction][LinEtAl-5][LinEtAl-7]") {
  const Vector2d normal(0.6, -0.8);
  const Traction on = traction(Vector3d(-2, -6, 1), normal);
  CHECK(on.normal == Approx(-5.52).epsilon(1e-14));
  CHECK(std::abs(on.tangential.dot(normal)) < 1e-14);
  CHECK((on.normal * normal + on.tangential - Vector2d(-2, 5.4)).norm() < 1e-14);
}

TEST_CASE("the shear on a face is against that on the facing one", "[traction][LinEtAl-7]") {
  const Traction up = traction(Vector3d(0, -1, 0.25), Vector2d(0, 1));
  const Traction down = traction(Vector3d(0, -1, 0.25), Vector2d(0, -1));
  CHECK(up.tangential == Vector2d(0.25, 0));
  CHECK(down.tangential == Vector2d(-0.25, 0));
  CHECK(up.normal == down.normal);
}

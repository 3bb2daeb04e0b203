#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using Eigen::Vector2d;
using Eigen::Vector3d;
using ex12_1::disc_stress;
using ex12_1::line_load_stress;

static const double pi = std::acos(-1.0);

TEST_CASE("ex12.1 straight below the force there is only its pressure", "[ex12.1]") {
  const Vector3d s = line_load_stress(3, {1, 2}, {0, -1}, {1, -2});
  CHECK(s[0] == 0);
  CHECK(s[1] == Approx(-2 * 3 / (pi * 4)).epsilon(1e-14));
  CHECK(s[2] == 0);
}

// At 45 degrees: r = sqrt 2, sigma_r = -2P cos 45 / (pi r) = -P/pi, half of it in each component.
TEST_CASE("ex12.1 beside the force the ray is pressed", "[ex12.1]") {
  const Vector3d s = line_load_stress(1, {0, 0}, {0, -1}, {1, -1});
  CHECK(equal_within(s, Vector3d(-1, -1, 1) / (2 * pi), 1e-15));
}

TEST_CASE("ex12.1 the middle of the disc", "[ex12.1]") {
  const Vector3d s = disc_stress(50, 41.76, 0, {0, 0});
  CHECK(s[0] == Approx(0.26585242).epsilon(1e-7));
  CHECK(s[1] == Approx(-0.79755726).epsilon(1e-7));
  CHECK(std::abs(s[2]) < 1e-15);
}

TEST_CASE("ex12.1 the rim is free", "[ex12.1]") {
  for (const double theta : {0.3, 1.0, 2.0, 3.0, 4.0, 6.0}) {
    CAPTURE(theta);
    const Vector2d at(2 * std::sin(theta), 2 * std::cos(theta));
    CHECK(disc_stress(2, 1, 0, at).norm() < 1e-14);
  }
}

TEST_CASE("ex12.1 tension across the load is the same all along it", "[ex12.1]") {
  for (const double y : {-0.9, -0.3, 0.5, 0.99})
    CHECK(disc_stress(1, pi, 0, {0, y})[0] == Approx(1).epsilon(1e-13));
}

TEST_CASE("ex12.1 under each of the loads the stress has no limit", "[ex12.1]") {
  CHECK_THROWS_AS(disc_stress(2, 1, 0, {0, 2}), std::invalid_argument);
  CHECK_THROWS_AS(disc_stress(2, 1, 0, {0, -2}), std::invalid_argument);
}

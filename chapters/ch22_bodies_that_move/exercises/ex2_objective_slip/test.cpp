#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex22_2;

namespace {

const Scene flat{{1, 0}, {0, 0}, {4, 0}};

Scene turned(const Scene& scene, double angle) {
  const auto turn = [angle](const Vector2d& x) -> Vector2d {
    return Vector2d(std::cos(angle) * x.x() - std::sin(angle) * x.y(),
                    std::sin(angle) * x.x() + std::cos(angle) * x.y()) +
           Vector2d(7, -2);
  };
  return {turn(scene.node), turn(scene.first), turn(scene.last)};
}

}  // namespace

TEST_CASE("ex22.2 a node over a quarter of the side", "[ex22.2]") {
  CHECK(place_faced(flat) == Approx(0.25));
  CHECK(place_faced({{5, 3}, {0, 0}, {4, 0}}) == Approx(1.25));
}

TEST_CASE("ex22.2 to the last end and back", "[ex22.2]") {
  CHECK(slip(flat, {{1.37, 0}, {0, 0}, {4, 0}}) == Approx(0.37));
  CHECK(slip(flat, {{0.5, 0}, {0, 0}, {4, 0}}) == Approx(-0.5));
  CHECK(slip(flat, flat) == Approx(0).margin(1e-15));
}

TEST_CASE("ex22.2 a turn of both is no slip", "[ex22.2]") {
  for (const double angle : {1e-3, 0.5, 1.5707963267948966, 3.0}) {
    CAPTURE(angle);
    CHECK(slip(flat, turned(flat, angle)) == Approx(0).margin(1e-14));
    CHECK(slip(flat, turned({{1.37, 0}, {0, 0}, {4, 0}}, angle)) == Approx(0.37).epsilon(1e-13));
  }
}

TEST_CASE("ex22.2 at the middle of a side that stretches", "[ex22.2]") {
  CHECK(slip({{2, 0}, {0, 0}, {4, 0}}, {{3, 0}, {0, 0}, {6, 0}}) == Approx(0).margin(1e-14));
}

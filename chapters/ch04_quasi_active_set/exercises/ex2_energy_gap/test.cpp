#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using Eigen::Matrix2d;
using Eigen::Vector2d;
using signorini::DenseProgramme;

namespace {

const DenseProgramme corner{Matrix2d::Identity(), Vector2d(2, 2), Matrix2d::Identity(),
                            Vector2d(1, 1)};

}  // namespace

TEST_CASE("ex4.2 the last step stops at the first row and knows what it may lose", "[ex4.2]") {
  const ex4_2::End end =
      ex4_2::last_step(corner, {Vector2d(0, 0), Vector2d(2, 2)}, {Vector2d(2, 1), Vector2d(0, 1)});
  REQUIRE(end.state.displacement.size() == 2);
  REQUIRE(end.state.force.size() == 2);
  CHECK(end.fraction == Approx(0.5).epsilon(1e-15));
  CHECK(equal_within(end.state.displacement, Vector2d(1, 0.5), 1e-15));
  CHECK(equal_within(end.state.force, Vector2d(1, 1.5), 1e-15));
  CHECK(end.energy == Approx(-2.375).epsilon(1e-15));
  CHECK(end.energy_gap == Approx(0.75).epsilon(1e-15));
  CHECK(end.energy - end.energy_gap <= -3);  // the least energy, at (1, 1)
  CHECK_FALSE(end.optimal);
}

TEST_CASE("ex4.2 a target that violates nothing is reached, and known to be optimal", "[ex4.2]") {
  const ex4_2::End end =
      ex4_2::last_step(corner, {Vector2d(0, 0), Vector2d(2, 2)}, {Vector2d(1, 1), Vector2d(1, 1)});
  REQUIRE(end.state.displacement.size() == 2);
  CHECK(end.fraction == 1);
  CHECK(end.state.displacement == Vector2d(1, 1));
  CHECK(end.energy == Approx(-3).epsilon(1e-15));
  CHECK(end.optimal);
}

// From (1/2, 0) a third of the way to (2, 1).
TEST_CASE("ex4.2 the last step may begin anywhere", "[ex4.2]") {
  const ex4_2::End end = ex4_2::last_step(corner, {Vector2d(0.5, 0), Vector2d(1.5, 2)},
                                          {Vector2d(2, 1), Vector2d(0, 1)});
  REQUIRE(end.state.displacement.size() == 2);
  CHECK(end.fraction == Approx(1.0 / 3).epsilon(1e-15));
  CHECK(equal_within(end.state.displacement, Vector2d(1, 1.0 / 3), 1e-15));
  CHECK(equal_within(end.state.force, Vector2d(1, 5.0 / 3), 1e-15));
}

#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/errors.hpp"
#include "support/equal_within.hpp"

using Eigen::Matrix3d;
using Eigen::Vector3d;
using ex13_2::come_to_rest;
using ex13_2::Rest;

// Three equal springs of compliance 2 at -1, 0, 1: force P/3 (1 + 3 e x / 2).
TEST_CASE("ex13.2 three springs under a load near their middle", "[ex13.2]") {
  const double e = GENERATE(-0.5, 0.0, 0.25);
  CAPTURE(e);
  const Rest rest = come_to_rest(2 * Matrix3d::Identity(), Vector3d(-1, 0, 1), 6, e);
  const Vector3d expected = 2 * Vector3d(1 - 1.5 * e, 1, 1 + 1.5 * e);
  REQUIRE(rest.force.size() == 3);
  CHECK(equal_within(rest.force, expected, 1e-13));
  CHECK(rest.settlement == Approx(4).epsilon(1e-13));
  CHECK(rest.tilt == Approx(6 * e).epsilon(1e-13).margin(1e-13));
}

// With e > 2/3 the left spring would pull: it lifts off, and two springs share the load by the lever.
TEST_CASE("ex13.2 the far spring lifts off", "[ex13.2]") {
  const Rest rest = come_to_rest(2 * Matrix3d::Identity(), Vector3d(-1, 0, 1), 6, 0.75);
  CHECK(rest.force(0) == 0);
  CHECK(rest.force(1) == Approx(1.5).epsilon(1e-13));
  CHECK(rest.force(2) == Approx(4.5).epsilon(1e-13));
  CHECK(rest.settlement == Approx(3).epsilon(1e-13));
  CHECK(rest.tilt == Approx(6).epsilon(1e-13));
}

TEST_CASE("ex13.2 beside all springs the footing topples", "[ex13.2]") {
  CHECK_THROWS_AS(come_to_rest(2 * Matrix3d::Identity(), Vector3d(-1, 0, 1), 6, -1.5),
                  signorini::NotSolved);
  CHECK_THROWS_AS(come_to_rest(2 * Matrix3d::Identity(), Eigen::Vector2d(-1, 1), 6, 0),
                  std::invalid_argument);
}

#include <algorithm>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using ex1_5::come_to_rest;
using ex1_5::Rest;

static signorini::ContactProblem carts() {
  return {(Matrix3d() << 1, 1, 1, 1, 2, 2, 1, 2, 3).finished(), Vector3d(-2, -1, -3)};
}

TEST_CASE("ex1.5 rigid stops are as they were", "[ex1.5]") {
  const Rest rest = come_to_rest(carts(), Vector3d::Zero());
  CHECK(equal_within(rest.force, Vector3d(1.5, 0, 0.5), 1e-14));
  CHECK(equal_within(rest.gap, Vector3d(0, 1.5, 0), 1e-14));
}

TEST_CASE("ex1.5 three carts on stops that yield", "[ex1.5]") {
  const Rest rest = come_to_rest(carts(), Vector3d::Ones());
  CHECK(equal_within(7 * rest.force, Vector3d(5, 0, 4), 1e-13));
  CHECK(equal_within(7 * rest.gap, Vector3d(-5, 6, -4), 1e-13));
}

// d + (G + c) lambda = 0 where the pair is closed.
TEST_CASE("ex1.5 one pair follows the closed form", "[ex1.5]") {
  const double d = GENERATE(-3.0, 0.0, 2.0);
  const double c = GENERATE(0.0, 0.5, 1e6);
  CAPTURE(d, c);
  const Rest rest = come_to_rest({MatrixXd::Constant(1, 1, 2), VectorXd::Constant(1, d)},
                                 VectorXd::Constant(1, c));
  CHECK(rest.force(0) == Approx(std::max(0.0, -d / (2 + c))).epsilon(1e-14).margin(1e-15));
  CHECK(rest.gap(0) == Approx(d + 2 * rest.force(0)).epsilon(1e-12).margin(1e-15));
}

TEST_CASE("ex1.5 every stop has its own yield, not negative", "[ex1.5]") {
  CHECK_THROWS_AS(come_to_rest(carts(), Vector2d(1, 1)), std::invalid_argument);
  CHECK_THROWS_AS(come_to_rest(carts(), Vector3d(1, -1, 1)), std::invalid_argument);
}

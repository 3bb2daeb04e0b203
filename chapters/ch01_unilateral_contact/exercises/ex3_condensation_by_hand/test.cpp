#include <stdexcept>

#include "../chapters/ch01_unilateral_contact/three_carts.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using namespace ex1_3;
using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::VectorXd;

static Body carts() { return {ch01::three_carts().stiffness, ch01::three_carts().load}; }

TEST_CASE("ex1.3 without the cart between them, two springs in a row are one of half", "[ex1.3]") {
  const Body left = without(carts(), 1);
  REQUIRE(left.load.size() == 2);
  CHECK(equal_within(left.stiffness, (Matrix2d() << 1.5, -0.5, -0.5, 0.5).finished(), 1e-15));
  CHECK(equal_within(left.load, Vector2d(0, 4), 1e-15));
}

// A pull at the middle cart arrives at its neighbours in halves.
TEST_CASE("ex1.3 the load of what leaves goes to its neighbours", "[ex1.3]") {
  Body pulled = carts();
  pulled.load(1) = 6;
  const Body left = without(pulled, 1);
  REQUIRE(left.load.size() == 2);
  CHECK(equal_within(left.load, Vector2d(3, 7), 1e-14));
}

TEST_CASE("ex1.3 stops in front of the first and the last cart", "[ex1.3]") {
  const Condensed two = condense(carts(), {0, 2}, Vector2d(2, 9));
  REQUIRE(two.compliance.rows() == 2);
  CHECK(equal_within(two.compliance, (Matrix2d() << 1, 1, 1, 3).finished(), 1e-14));
  CHECK(equal_within(two.free_gap, Vector2d(-2, -3), 1e-14));
  const Condensed one = condense(carts(), {2}, VectorXd::Constant(1, 9));
  CHECK(equal_within(one.compliance, Eigen::MatrixXd::Constant(1, 1, 3), 1e-14));
}

TEST_CASE("ex1.3 what cannot be meant is refused", "[ex1.3]") {
  CHECK_THROWS_AS(without(carts(), 3), std::invalid_argument);
  CHECK_THROWS_AS(condense(carts(), {0, 2}, VectorXd::Ones(3)), std::invalid_argument);
  CHECK_THROWS_AS(condense(carts(), {0, 3}, Vector2d(1, 1)), std::invalid_argument);
}

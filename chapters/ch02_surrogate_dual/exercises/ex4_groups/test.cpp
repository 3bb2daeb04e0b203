#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using ex2_4::trade_groups;
using ex2_4::Traded;

static signorini::ContactProblem carts() {
  return {(Matrix3d() << 1, 1, 1, 1, 2, 2, 1, 2, 3).finished(), Vector3d(-2, -1, -3)};
}

TEST_CASE("ex2.4 one group is one weighted gap", "[ex2.4]") {
  const Traded traded = trade_groups(carts(), Vector3d(5, 5, 5), {0, 0, 0});
  REQUIRE(traded.total.size() == 1);
  CHECK(traded.total(0) == Approx(9.0 / 7).epsilon(1e-14));
  CHECK(traded.energy == Approx(9.0 / 7).epsilon(1e-14));
  CHECK(equal_within(traded.force, Vector3d::Constant(3.0 / 7), 1e-14));
}

TEST_CASE("ex2.4 two groups, of which one does not press", "[ex2.4]") {
  const Traded traded = trade_groups(carts(), Vector3d(1, 1, 1), {0, 1, 0});
  REQUIRE(traded.total.size() == 2);
  CHECK(equal_within(traded.total, Vector2d(5.0 / 3, 0), 1e-14));
  CHECK(equal_within(traded.force, Vector3d(5.0 / 6, 0, 5.0 / 6), 1e-14));
  CHECK(traded.energy == Approx(25.0 / 12).epsilon(1e-14));
}

TEST_CASE("ex2.4 a group for each pair is the contact problem", "[ex2.4]") {
  const Traded traded = trade_groups(carts(), Vector3d(2, 3, 4), {2, 0, 1});
  REQUIRE(traded.total.size() == 3);
  CHECK(equal_within(traded.force, Vector3d(1.5, 0, 0.5), 1e-13));
  CHECK(equal_within(traded.total, Vector3d(0, 0.5, 1.5), 1e-13));
  CHECK(traded.energy == Approx(2.25).epsilon(1e-14));
}

TEST_CASE("ex2.4 what cannot be meant is refused", "[ex2.4]") {
  CHECK_THROWS_AS(trade_groups(carts(), Vector3d(1, -1, 1), {0, 0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(trade_groups(carts(), Vector2d(1, 1), {0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(trade_groups(carts(), Vector3d(1, 0, 1), {0, 1, 0}), std::invalid_argument);
}

#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using namespace ex5_3;
using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

static Table carts() {
  return {(Matrix3d() << 1, 1, 1, 1, 2, 2, 1, 2, 3).finished(),
          Vector3d(-2, -1, -3),
          {false, false, false}};
}

// w1 = -7 + 2 l1 + l2 becomes l1 = 7/2 + w1/2 - l2/2, and w2 = -5 + l1 + 2 l2 follows.
TEST_CASE("ex5.3 one pair changes sides", "[ex5.3]") {
  Table table{(Matrix2d() << 2, 1, 1, 2).finished(), Vector2d(-7, -5), {false, false}};
  exchange(table, 0);
  CHECK(equal_within(table.M, (Matrix2d() << 0.5, -0.5, 0.5, 1.5).finished(), 1e-15));
  CHECK(equal_within(table.q, Vector2d(3.5, -1.5), 1e-15));
  CHECK(table.closed == std::vector<bool>{true, false});
}

TEST_CASE("ex5.3 three carts in two steps", "[ex5.3]") {
  Table table = carts();
  CHECK(exchange_wrong_pairs(table) == std::vector<Index>{0, 1, 2});
  CHECK(equal_within(table.q, Vector3d(3, -3, 2), 1e-14));
  CHECK(exchange_wrong_pairs(table) == std::vector<Index>{1});
  CHECK(equal_within(table.q, Vector3d(1.5, 1.5, 0.5), 1e-14));
  CHECK(table.closed == std::vector<bool>{true, false, true});
  CHECK(exchange_wrong_pairs(table) == decltype(exchange_wrong_pairs(table)){});
}

TEST_CASE("ex5.3 steps and what they cost", "[ex5.3]") {
  const Run run = drive({carts().M, carts().q}, 10);
  CHECK(run.solved);
  CHECK(run.steps == 2);
  CHECK(run.exchanges == 4);
  CHECK(equal_within(run.force, Vector3d(1.5, 0, 0.5), 1e-14));
}

TEST_CASE("ex5.3 what cannot change is refused", "[ex5.3]") {
  Table table = carts();
  CHECK_THROWS_AS(exchange(table, 3), std::invalid_argument);
  table.M(1, 1) = 0;
  CHECK_THROWS_AS(exchange(table, 1), std::invalid_argument);
  CHECK(table.q == Vector3d(-2, -1, -3));
}

TEST_CASE("ex5.3 a pair that just touches is on the right side", "[ex5.3]") {
  Table table{Matrix2d::Identity(), Eigen::Vector2d(0, 1), {false, true}};
  CHECK(exchange_wrong_pairs(table) == std::vector<Index>{});
}

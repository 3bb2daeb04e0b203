#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::VectorXd;

// At the first vertex eta = 3 closes pair 1, and pair 2 still overlaps by 2.
TEST_CASE("ex2.1 the pair that is left out overlaps and asks for weight", "[ex2.1]") {
  const Matrix2d G = Vector2d(1, 2).asDiagonal();
  const VectorXd slope = ex2_1::gradient(G, Vector2d(-3, -2), Vector2d(1, 0));
  REQUIRE(slope.size() == 2);
  CHECK(equal_within(slope, Vector2d(0, 6), 1e-14));
}

// eta = 2.5 / 0.75 = 10/3; the gaps left are -3 + 5/3 and -2 + 10/3.
TEST_CASE("ex2.1 in the middle weight moves from the open to the overlapping pair", "[ex2.1]") {
  const Matrix2d G = Vector2d(1, 2).asDiagonal();
  const VectorXd slope = ex2_1::gradient(G, Vector2d(-3, -2), Vector2d(0.5, 0.5));
  REQUIRE(slope.size() == 2);
  CHECK(equal_within(slope, Vector2d(40, -40) / 9, 1e-14));
}

// Weights in proportion to the forces (3, 1): the top of the hill.
TEST_CASE("ex2.1 the slope vanishes at the forces", "[ex2.1]") {
  const Matrix2d G = Vector2d(1, 2).asDiagonal();
  const VectorXd slope = ex2_1::gradient(G, Vector2d(-3, -2), Vector2d(0.75, 0.25));
  REQUIRE(slope.size() == 2);
  CHECK(slope.norm() < 1e-14);
  CHECK(ex2_1::gradient(G, Vector2d(-3, -2), Vector2d(1, 0))(1) > 1);  // but not everywhere
}

TEST_CASE("ex2.1 where the weighted gap is open there is no slope", "[ex2.1]") {
  const Eigen::VectorXd slope =
      ex2_1::gradient(Eigen::Matrix2d::Identity(), Vector2d(2, -1), Vector2d(1, 0.5));
  CHECK(equal_within(slope, Vector2d(0, 0), 0));
}

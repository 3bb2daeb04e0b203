#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using Rows = std::vector<Index>;

// Between two half-planes only one row is violated at a time; K = I.
TEST_CASE("ex4.1 the zigzag of figure 4.2", "[ex4.1]") {
  const Matrix2d A = (Matrix2d() << 0, 1, 1, -1).finished();
  const struct {
    Vector2d to;
    double force;
    Index row;
  } steps[] = {{{1, 0}, 2, 0}, {{0.5, 0.5}, 0.5, 1}, {{0.5, 0}, 0.5, 0}, {{0.25, 0.25}, 0.25, 1}};
  VectorXd u = Vector2d(1, 2);
  for (const auto& expected : steps) {
    const ex4_1::Moved moved = ex4_1::move_minimum(Matrix2d::Identity(), A, Vector2d(0, 0), u);
    REQUIRE(moved.violated == Rows{expected.row});
    REQUIRE(moved.weights.size() == 1);
    CHECK(moved.weights(0) == Approx(1).epsilon(1e-15));
    CHECK(moved.total_force == Approx(expected.force).epsilon(1e-15));
    CHECK(equal_within(moved.displacement, expected.to, 1e-15));
    u = moved.displacement;
  }
}

// G = [4 1; 1 1/2] for the violated rows 0 and 2, overlaps 4 and 1/2: closing row 0 alone opens row 2.
TEST_CASE("ex4.1 of two violated rows one bears nothing", "[ex4.1]") {
  const Matrix2d K = Vector2d(1, 2).asDiagonal();
  MatrixXd A(3, 2);
  A << 2, 0, 0, 1, 0.5, 0.5;
  Eigen::Vector3d g(2, 9, 2.5);
  const ex4_1::Moved moved = ex4_1::move_minimum(K, A, g, Vector2d(3, 3));
  REQUIRE(moved.violated == Rows{0, 2});
  REQUIRE(moved.weights.size() == 2);
  CHECK(moved.total_force == Approx(1).epsilon(1e-14));
  CHECK(equal_within(moved.weights, Vector2d(1, 0), 1e-14));
  CHECK(equal_within(moved.displacement, Vector2d(1, 3), 1e-14));
}

TEST_CASE("ex4.1 a minimum that violates nothing stays", "[ex4.1]") {
  const ex4_1::Moved moved = ex4_1::move_minimum(Matrix2d::Identity(), Matrix2d::Identity(),
                                                 Vector2d(1, 2), Vector2d(1, 0));
  CHECK(moved.violated == decltype(moved.violated){});
  CHECK(moved.total_force == 0);
  REQUIRE(moved.displacement.size() == 2);
  CHECK(moved.displacement == Vector2d(1, 0));
}

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using Corners = Eigen::Matrix<double, 3, 2>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

static Eigen::Matrix3d simple() { return Eigen::Vector3d(1, 1, 0.5).asDiagonal(); }

static Corners unit() { return (Corners() << 0, 0, 1, 0, 0, 1).finished(); }

TEST_CASE("ex0.1 the triangle of paper and pencil", "[ex0.1]") {
  const Matrix6d K = ex0_1::triangle_stiffness(unit(), simple(), 1);
  Eigen::Matrix<double, 1, 6> first;
  first << 3, 1, -2, -1, -1, 0;
  CHECK(equal_within(4 * K.row(0), first, 1e-14));
  CHECK(equal_within(K, K.transpose(), 1e-14));
}

TEST_CASE("ex0.1 twice as thick is twice as stiff, twice as large is as stiff", "[ex0.1]") {
  const Matrix6d K = ex0_1::triangle_stiffness(unit(), simple(), 1);
  CHECK(K.norm() > 1);
  CHECK(equal_within(ex0_1::triangle_stiffness(unit(), simple(), 2), 2 * K, 1e-14));
  CHECK(equal_within(ex0_1::triangle_stiffness(2 * unit(), simple(), 1), K, 1e-14));
}

TEST_CASE("ex0.1 translations and a turn need no force", "[ex0.1]") {
  const Corners corners = (Corners() << 1, 2, 4, 1, 2, 5).finished();
  const Matrix6d K = ex0_1::triangle_stiffness(corners, simple(), 1);
  CHECK(K.norm() > 1);
  Eigen::Matrix<double, 6, 3> rigid;
  for (Eigen::Index k = 0; k < 3; ++k)
    rigid.middleRows<2>(2 * k) << 1, 0, -corners(k, 1), 0, 1, corners(k, 0);
  CHECK((K * rigid).norm() < 1e-13);
}

TEST_CASE("ex0.1 it does not matter where the triangle stands", "[ex0.1]") {
  const Corners moved = unit().rowwise() + Eigen::RowVector2d(3, 5);
  CHECK(equal_within(ex0_1::triangle_stiffness(moved, simple(), 1),
                     ex0_1::triangle_stiffness(unit(), simple(), 1), 1e-14));
}

TEST_CASE("ex0.1 a triangle that is turned has the same matrix, turned", "[ex0.1]") {
  const Eigen::Matrix2d turn = (Eigen::Matrix2d() << 0.6, -0.8, 0.8, 0.6).finished();
  Matrix6d T = Matrix6d::Zero();
  for (Eigen::Index k = 0; k < 6; k += 2) T.block<2, 2>(k, k) = turn;
  const Corners turned = unit() * turn.transpose();
  CHECK(equal_within(ex0_1::triangle_stiffness(turned, simple(), 1),
                     T * ex0_1::triangle_stiffness(unit(), simple(), 1) * T.transpose(), 1e-14));
}

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using ex3_4::update;

TEST_CASE("ex3.4 where all rows are alike nothing changes", "[ex3.4]") {
  const VectorXd next =
      update({(Matrix2d() << 2, 1, 1, 2).finished(), Vector2d(-7, -5)}, Vector2d(0.5, 0.5));
  CHECK(equal_within(next, Vector2d(0.75, 0.25), 1e-14));
}

TEST_CASE("ex3.4 three carts, by what an overlap means", "[ex3.4]") {
  const VectorXd next =
      update({(Matrix3d() << 1, 1, 1, 1, 2, 2, 1, 2, 3).finished(), Vector3d(-2, -1, -3)},
             Vector3d(0, 1, 0));
  CHECK(equal_within(next, Vector3d(1, 0, 0), 1e-14));
}

// Row 2 in units of a tenth: its overlap is ten times as large, its force a tenth. The weights that were 3/4 and 1/4
// are now as 3/4 to 1/40.
TEST_CASE("ex3.4 one row in another unit", "[ex3.4]") {
  const Vector2d row(1, 10);
  const Matrix2d G = (Matrix2d() << 2, 1, 1, 2).finished();
  const VectorXd next =
      update({row.asDiagonal() * G * row.asDiagonal(), Vector2d(-7, -50)}, Vector2d(10, 1) / 11);
  CHECK(next.sum() == Approx(1).epsilon(1e-14));
  CHECK(next(0) / next(1) == Approx(30).epsilon(1e-12));
}

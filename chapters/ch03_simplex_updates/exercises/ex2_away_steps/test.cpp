#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

TEST_CASE("ex3.2 weight on an open pair is taken away for good", "[ex3.2]") {
  const Matrix2d G = Matrix2d::Identity();
  const VectorXd next = ex3_2::away_step(G, Vector2d(-1, 1), Vector2d(0.8, 0.2));
  REQUIRE(next.size() == 2);
  CHECK(next(0) == Approx(1).epsilon(1e-15));
  CHECK(next(1) == 0);
  const VectorXd rest = ex3_2::away_step(G, Vector2d(-1, 1), Vector2d(1, 0));
  CHECK(equal_within(rest, Vector2d(1, 0), 1e-15));
}

// Three pairs that do not feel each other. Under eta xi the gaps are about (-0.4, -0.1, 1.1): the third
// pair is the larger fault, and s rises all the way to the border.
TEST_CASE("ex3.2 an away step keeps the ratio of the other weights", "[ex3.2]") {
  const Eigen::Matrix3d G = Eigen::Matrix3d::Identity();
  const VectorXd next = ex3_2::away_step(G, Vector3d(-2, -1, 0.5), Vector3d(0.5, 0.3, 0.2));
  REQUIRE(next.size() == 3);
  CHECK(equal_within(next, Vector3d(0.625, 0.375, 0), 1e-14));
  CHECK(next(2) == 0);
}

TEST_CASE("ex3.2 the larger fault decides: here towards the overlapping pair", "[ex3.2]") {
  const Matrix2d G = (Matrix2d() << 2, 1, 1, 2).finished();
  const VectorXd next = ex3_2::away_step(G, Vector2d(-7, -5), Vector2d(0.5, 0.5));
  REQUIRE(next.size() == 2);
  CHECK(equal_within(next, Vector2d(0.75, 0.25), 1e-14));
}

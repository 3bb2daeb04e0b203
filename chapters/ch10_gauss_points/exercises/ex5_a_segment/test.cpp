#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using namespace ex10_5;
using Eigen::Matrix2d;
using Eigen::Vector2d;

static Edges level(double a, double b, double c, double d, double gap = 0) {
  return {{a, 2}, {b, 2}, {c, 2 - gap}, {d, 2 - gap}};
}

TEST_CASE("ex10.5 the part that faces the other edge", "[ex10.5]") {
  const Segment part = mortar_segment(level(0, 1, 2.0 / 3, 4.0 / 3));
  CHECK(part.from == Approx(1.0 / 3).epsilon(1e-14));
  CHECK(part.to == Approx(1).epsilon(1e-14));
  CHECK(part.D(1) == Approx(0.5).epsilon(1e-14));
  CHECK(part.D(0) == Approx(-1.0 / 6).epsilon(1e-14));
  CHECK(mortar_segment(level(0, 1, 2, 3)).D.norm() == 0);
  CHECK(mortar_segment(level(0, 1, 1, 2)).to == 0);  // they meet in a point only
}

TEST_CASE("ex10.5 an edge over itself: dual functions see their own node only", "[ex10.5]") {
  const Segment whole = mortar_segment(level(0, 3, 0, 3, 0.25));
  CHECK(equal_within(whole.M, 1.5 * Matrix2d::Identity(), 1e-14));
  CHECK(equal_within(whole.D, Vector2d(1.5, 1.5), 1e-14));
  CHECK(equal_within(whole.gap, 0.25 * Vector2d(1.5, 1.5), 1e-14));
}

TEST_CASE("ex10.5 two edges over three: the row of the chapter", "[ex10.5][LinEtAl-36]") {
  const double x[] = {0, 2.0 / 3, 4.0 / 3, 2};
  Eigen::RowVector4d row = Eigen::RowVector4d::Zero();
  double share = 0;
  for (int j = 0; j < 3; ++j) {
    const Segment left = mortar_segment(level(0, 1, x[j], x[j + 1]));
    const Segment right = mortar_segment(level(1, 2, x[j], x[j + 1]));
    row.segment<2>(j) += left.M.row(1) + right.M.row(0);
    share += left.D(1) + right.D(0);
  }
  CHECK(share == Approx(1).epsilon(1e-14));
  CHECK(equal_within(row / share, Eigen::RowVector4d(-2, 11, 11, -2) / 18, 1e-14));
}

#include <cmath>
#include <vector>

#include "catch_compat.hpp"
#include "signorini/fem/element.hpp"
#include "signorini/pairing/dual_basis.hpp"
#include "support/random.hpp"

using Eigen::Matrix2d;
using Eigen::Vector2d;
using namespace signorini;
using signorini_test::Random;

namespace {

/// Points of [a, b] on an edge of length 2 that is stretched unevenly, as by a midpoint off the middle.
std::vector<EdgePoint> points_of(double a, double b, double uneven = 0) {
  std::vector<EdgePoint> points;
  for (const GaussPoint& gauss : gauss_line(3)) {
    const double s = 0.5 * (a + b) + 0.5 * (b - a) * gauss.xi;
    points.push_back({s, 0.5 * (b - a) * gauss.weight * (1 + uneven * s)});
  }
  return points;
}

Vector2d share_of(const std::vector<EdgePoint>& points) {
  Vector2d share = Vector2d::Zero();
  for (const EdgePoint& point : points) share += point.length * end_shape(point.s);
  return share;
}

DualBasis basis_of(double a, double b, double uneven = 0) {
  return dual_basis(points_of(a, b, uneven), share_of(points_of(-1, 1, uneven)));
}

/// Integrals of psi_i N_j and, in the diagonal of the second, of psi_i.
Matrix2d products(const DualBasis& basis, const std::vector<EdgePoint>& points) {
  Matrix2d sum = Matrix2d::Zero();
  for (const EdgePoint& point : points)
    sum += point.length * basis.value(point.s) * end_shape(point.s).transpose();
  return sum;
}

}  // namespace

TEST_CASE("on a whole straight edge the dual functions are (1 - 3 s)/2 and (1 + 3 s)/2",
          "[mortar]") {
  const DualBasis basis = basis_of(-1, 1);
  for (const double s : {-1.0, -0.3, 0.0, 0.7, 1.0}) {
    CHECK(basis.value(s)(0) == Approx((1 - 3 * s) / 2).margin(1e-15));
    CHECK(basis.value(s)(1) == Approx((1 + 3 * s) / 2).margin(1e-15));
  }
}

TEST_CASE("dual functions are blind to the other end and average as their own, whatever is covered",
          "[mortar]") {
  Random random(17);
  int kept = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const double a = random.uniform(-1, 0);
    const double b = random.uniform(0, 1);
    const double uneven = trial % 2 == 0 ? 0 : random.uniform(-0.9, 0.9);
    CAPTURE(trial, a, b, uneven);
    const std::vector<EdgePoint> covered = points_of(a, b, uneven);
    const DualBasis basis = basis_of(a, b, uneven);
    const Matrix2d sum = products(basis, covered);
    CHECK(std::abs(sum.sum() - basis.length) <= 1e-14);  // the two add up to 1
    if (basis.slope == 0) continue;
    ++kept;
    const Vector2d own = share_of(covered);
    CHECK((sum - Matrix2d(own.asDiagonal())).cwiseAbs().maxCoeff() <= 1e-14);
    CHECK((basis.length * basis.mean - own).cwiseAbs().maxCoeff() <= 1e-14);
  }
  CHECK(kept > 50);
}

TEST_CASE("what an edge gives to an end is bounded however little is covered", "[mortar]") {
  // The steepest pair that is kept covers the middle half: psi_1 = (1 - 6 s')/2 with s' in [-1, 1].
  for (int left = 0; left < 40; ++left)
    for (int right = left + 1; right <= 40; ++right) {
      const double a = -1 + left / 20.0;
      const double b = -1 + right / 20.0;
      const DualBasis basis = basis_of(a, b);
      CAPTURE(a, b);
      for (const double s : {a, b})
        for (int i = 0; i < 2; ++i)
          CHECK(std::abs(basis.value(s)(i)) <= (7 + 1e-12) * basis.mean(i));
    }
}

TEST_CASE("a sliver belongs to the end that it is nearer to", "[mortar]") {
  for (const double width : {1e-12, 1e-6, 0.1}) {
    CAPTURE(width);
    const DualBasis at_first = basis_of(-1, -1 + width);
    const DualBasis at_last = basis_of(1 - width, 1);
    const DualBasis in_second_half = basis_of(0.1, 0.1 + width);
    CHECK(at_first.value(-1) == Vector2d(1, 0));
    CHECK(at_last.value(1) == Vector2d(0, 1));
    CHECK(in_second_half.value(0.1) == Vector2d(0, 1));
    CHECK(at_first.length == Approx(width).epsilon(1e-3));  // 1e-12 next to 1 is rounded
  }
}

TEST_CASE("an end keeps its function as long as half of its share is covered", "[mortar]") {
  // The share of the last end that [-1, b] covers is ((1 + b)/2)^2.
  const double half = 2 * std::sqrt(0.5) - 1;
  CHECK(basis_of(-1, half - 1e-6).value(0) == Vector2d(1, 0));
  CHECK(basis_of(-1, half + 1e-6).mean(1) > 0.3);
  CHECK(basis_of(-0.5, 0.5).slope == Approx(6));  // a tie: both keep theirs
}

TEST_CASE("one point cannot tell two ends apart, and nothing covered gives nothing", "[mortar]") {
  const std::vector<EdgePoint> one = {{0, 2}};
  CHECK(dual_basis(one, share_of(one)).value(0) == Vector2d(0.5, 0.5));
  const DualBasis nothing = dual_basis({}, share_of(one));
  CHECK(nothing.length == 0);
  CHECK(nothing.value(0.3) == Vector2d(0, 0));
}

#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"

using signorini::NodeArray;

// One point above the line y = a + m x.
static ex1_1::LinearGaps above_line(double x, double y, double a, double m) {
  NodeArray point(1, 2);
  point << x, y;
  return ex1_1::profile_gaps(
      point, [a, m](double s) { return a + m * s; }, [m](double) { return m; });
}

TEST_CASE("ex1.1 above a flat floor the gap is the height", "[ex1.1]") {
  const ex1_1::LinearGaps gaps = above_line(7, 2.5, 1, 0);
  CHECK(gaps.initial_gap(0) == Approx(1.5).epsilon(1e-14));
  CHECK(gaps.A(0, 0) == Approx(0).margin(1e-15));
  CHECK(gaps.A(0, 1) == Approx(-1).epsilon(1e-14));  // minus the normal: up is positive
}

// A slope of 3/4 makes a triangle with sides 3, 4, 5. Divided by the root twice, the gap would be 0.8.
TEST_CASE("ex1.1 the distance to a straight line is exact", "[ex1.1]") {
  const double m = GENERATE(0.75, -0.75);
  const ex1_1::LinearGaps gaps = above_line(2, 1.25 + 2 * m, 0, m);
  CAPTURE(m);
  CHECK(gaps.initial_gap(0) == Approx(1.0).epsilon(1e-14));
  CHECK(gaps.A(0, 0) == Approx(0.8 * m).epsilon(1e-14));
  CHECK(gaps.A(0, 1) == Approx(-0.8).epsilon(1e-14));
}

TEST_CASE("ex1.1 a point below the line has a negative gap", "[ex1.1]") {
  CHECK(above_line(0, -1.25, 0, 0.75).initial_gap(0) == Approx(-1.0).epsilon(1e-14));
}

// Halving the height above a circle must quarter the error: the formula is exact up to gap^2.
TEST_CASE("ex1.1 the distance to a circle has a second-order error", "[ex1.1]") {
  const double x = GENERATE(-0.6, 0.3, 0.8);
  const auto height = [](double s) { return std::sqrt(1 - s * s); };
  const auto slope = [](double s) { return -s / std::sqrt(1 - s * s); };
  const auto error = [&](double above) {
    NodeArray point(1, 2);
    point << x, height(x) + above;
    const double distance = point.row(0).norm() - 1;
    return std::abs(ex1_1::profile_gaps(point, height, slope).initial_gap(0) - distance);
  };
  CAPTURE(x);
  CHECK(error(0.01) < 1e-4);
  CHECK(error(0.01) / error(0.005) == Approx(4).epsilon(0.02));
}

TEST_CASE("ex1.1 sliding along the line keeps the gap, lifting opens it", "[ex1.1]") {
  const double m = 0.75;
  const ex1_1::LinearGaps gaps = above_line(0, 1.25, 0, m);
  const Eigen::Vector2d along(4, 3);
  const Eigen::Vector2d away(-3, 4);  // 5 [length] along the normal
  const auto gap = [&](const Eigen::Vector2d& u) {
    return gaps.initial_gap(0) - gaps.A.row(0).dot(u);
  };
  CHECK(gap(along) == Approx(1).epsilon(1e-14));
  CHECK(gap(away) == Approx(6).epsilon(1e-14));
}

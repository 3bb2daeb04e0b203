#include <cmath>
#include <limits>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/contact/obstacle.hpp"
#include "signorini/core/errors.hpp"
#include "support/equal_within.hpp"

using signorini::NodeArray;

static double valley(double x) { return 0.3 * x * x - x; }
static double valley_slope(double x) { return 0.6 * x - 1; }

TEST_CASE("ex1.1 held out: every point has its own normal and its own columns", "[ex1.1]") {
  NodeArray points(4, 2);
  points << -2, 5, 0, 0.1, 1.5, -2, 4, 4.25;
  const ex1_1::LinearGaps gaps = ex1_1::profile_gaps(points, valley, valley_slope);
  const signorini::Obstacle floor = signorini::profile(valley, valley_slope);
  REQUIRE(gaps.initial_gap.size() == 4);
  REQUIRE(gaps.A.rows() == 4);
  REQUIRE(gaps.A.cols() == 8);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(4, 8);
  for (Eigen::Index i = 0; i < 4; ++i) {
    const signorini::ObstacleContact seen = floor.look(points.row(i).transpose());
    CHECK(gaps.initial_gap(i) == Approx(seen.gap).epsilon(1e-13));
    expected.row(i).segment<2>(2 * i) = -seen.normal.transpose();
  }
  CHECK((gaps.A - expected).cwiseAbs().maxCoeff() < 1e-14);
}

// On a nearly vertical wall the height means little, the distance is 1e-8 times the height.
TEST_CASE("ex1.1 held out: a steep slope", "[ex1.1]") {
  const double m = GENERATE(1e8, -1e8);
  NodeArray point(1, 2);
  point << 0, 2;
  const ex1_1::LinearGaps gaps = ex1_1::profile_gaps(
      point, [](double) { return 0.0; }, [m](double) { return m; });
  CAPTURE(m);
  CHECK(gaps.initial_gap(0) == Approx(2e-8).epsilon(1e-12));
  CHECK(gaps.A(0, 0) == Approx(m > 0 ? 1 : -1).epsilon(1e-14));
  CHECK(gaps.A.row(0).norm() == Approx(1).epsilon(1e-14));
}

// In millimetres all lengths are 1000 times those in metres; the slope and the normal stay.
TEST_CASE("ex1.1 held out: a change of the unit of length", "[ex1.1]") {
  NodeArray point(1, 2);
  point << 1.5, -0.2;
  const ex1_1::LinearGaps metres = ex1_1::profile_gaps(point, valley, valley_slope);
  const ex1_1::LinearGaps millimetres = ex1_1::profile_gaps(
      1000 * point, [](double x) { return 1000 * valley(x / 1000); },
      [](double x) { return valley_slope(x / 1000); });
  CHECK(metres.initial_gap(0) == Approx((valley(1.5) + 0.2) / -std::hypot(1, 0.1)).epsilon(1e-13));
  CHECK(millimetres.initial_gap(0) == Approx(1000 * metres.initial_gap(0)).epsilon(1e-13));
  CHECK(equal_within(millimetres.A, metres.A, 1e-14));
}

TEST_CASE("ex1.1 held out: no points, and numbers that are not finite", "[ex1.1]") {
  const ex1_1::LinearGaps none = ex1_1::profile_gaps(NodeArray(0, 2), valley, valley_slope);
  CHECK(none.initial_gap.size() == 0);
  CHECK(none.A.size() == 0);
  const auto wall = [](double) { return std::numeric_limits<double>::infinity(); };
  CHECK_THROWS_AS(ex1_1::profile_gaps(NodeArray::Zero(1, 2), valley, wall),
                  signorini::ProblemError);
  CHECK_THROWS_AS(ex1_1::profile_gaps(NodeArray::Zero(1, 2), wall, valley_slope),
                  signorini::ProblemError);
}

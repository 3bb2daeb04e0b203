#include <cmath>
#include <limits>
#include <stdexcept>

#include "catch_compat.hpp"
#include "closed_form/footing.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using Eigen::Index;
using Eigen::VectorXd;
using ex13_5::shares;
using ex13_5::Strip;

// Many nodes: the moment is the load times e. Each force acts at its node to within a spacing.
TEST_CASE("ex13.5 held out: the moment is that of the load", "[ex13.5]") {
  const VectorXd position = VectorXd::LinSpaced(20001, -2, 2);
  for (const double e : {-1.9, -1.2, -1.0, -0.3, 0.7, 1.0, 1.5}) {
    CAPTURE(e);
    const VectorXd share = shares({2, 5, e}, position);
    CHECK(share.sum() == Approx(5).epsilon(1e-12));
    CHECK(share.dot(position) == Approx(5 * e).epsilon(1e-4));
  }
}

TEST_CASE("ex13.5 held out: as the closed form of the library where that holds", "[ex13.5]") {
  VectorXd position(6);
  position << -1.5, -1.4, -0.2, 0.1, 1.3, 1.5;
  for (const double e : {-0.75, -0.2, 0.4, 0.75}) {
    const VectorXd share = shares({1.5, 45, e}, position);
    for (Index k = 1; k < 5; ++k)
      CHECK(share(k) == Approx(rigid_strip_force(signorini::RigidStrip{1.5, 45, e},
                                                 (position(k - 1) + position(k)) / 2,
                                                 (position(k) + position(k + 1)) / 2))
                            .epsilon(1e-12));
  }
}

// The load is above a quarter of what bears, the pressure at the end that lifts off is zero.
TEST_CASE("ex13.5 held out: what bears beyond a/2 is a shorter strip", "[ex13.5]") {
  const VectorXd whole = VectorXd::LinSpaced(41, -1, 1);
  const double e = 0.8, b = 2 * (1 - e);
  const VectorXd share = shares({1, 7, e}, whole);
  VectorXd same = shares({b, 7, b / 2}, whole.array() - (1 - b));
  CHECK(equal_within(share, same, 1e-13));
  for (Index k = 0; k < whole.size(); ++k) {
    CAPTURE(whole(k));
    if (whole(k) < 1 - 2 * b - 0.026)
      CHECK(share(k) == 0);
    else if (whole(k) > 1 - 2 * b + 0.026)
      CHECK(share(k) > 0);
  }
}

TEST_CASE("ex13.5 held out: a mirror, and the place where it begins to lift off", "[ex13.5]") {
  const VectorXd position = VectorXd::LinSpaced(12, -3, 3);
  for (const double e : {0.4, 1.5, 2.2}) {
    const VectorXd right = shares({3, 2, e}, position), left = shares({3, 2, -e}, position);
    CHECK(equal_within(right, left.reverse(), 1e-13));
  }
  const VectorXd below = shares({3, 2, 1.5 * (1 - 1e-9)}, position);
  const VectorXd above = shares({3, 2, 1.5 * (1 + 1e-9)}, position);
  CHECK(equal_within(below, above, 1e-8));
}

TEST_CASE("ex13.5 held out: units", "[ex13.5]") {
  const VectorXd position = VectorXd::LinSpaced(9, -1, 1);
  for (const double e : {0.3, 0.7}) {
    const VectorXd plain = shares({1, 1, e}, position);
    for (const double unit : {1e-9, 1e9})
      CHECK(equal_within(shares({unit, 2 * unit, e * unit}, unit * position) / (2 * unit), plain,
                         1e-12));
  }
}

TEST_CASE("ex13.5 held out: what is no strip, and what topples", "[ex13.5]") {
  const VectorXd position = VectorXd::LinSpaced(3, -1, 1);
  for (const Strip& strip : {Strip{0, 1, 0}, Strip{1, 0, 0}, Strip{1, 1, -1}, Strip{1, 1, 1.2},
                             Strip{1, 1, std::numeric_limits<double>::quiet_NaN()}})
    CHECK_THROWS_AS(shares(strip, position), std::invalid_argument);
}

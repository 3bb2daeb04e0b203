#include "catch_compat.hpp"
#include "exercise.hpp"

using Eigen::VectorXd;
using ex19_2::Term;

static VectorXd one(double value) { return VectorXd::Constant(1, value); }

TEST_CASE("ex19.2 one unknown, by hand", "[ex19.2]") {
  const ex19_2::Point bar{one(-2), one(1), -1, 1};
  const Term pressed = ex19_2::nitsche_term(bar, one(0), 4, 1);
  CHECK(pressed.force(0) == Approx(-6).epsilon(1e-15));
  CHECK(pressed.slope(0, 0) == Approx(8).epsilon(1e-15));
  const Term shortest = ex19_2::nitsche_term(bar, one(0), 4, 0);
  CHECK(shortest.force(0) == Approx(-4).epsilon(1e-15));
  CHECK(shortest.slope(0, 0) == Approx(6).epsilon(1e-15));
}

TEST_CASE("ex19.2 an open point keeps the first part only", "[ex19.2]") {
  const ex19_2::Point bar{one(-2), one(1), 1, 0.5};
  const Term open = ex19_2::nitsche_term(bar, one(1), 4, 1);
  CHECK(open.force(0) == Approx(-0.5 / 4 * 4).epsilon(1e-15));
  CHECK(open.slope(0, 0) == Approx(-0.5 / 4 * 4).epsilon(1e-15));
  const Term none = ex19_2::nitsche_term(bar, one(1), 4, 0);
  CHECK(none.force(0) == 0);
  CHECK(none.slope(0, 0) == 0);
}

// A bar of stiffness 2 that overlaps by 1: its solution u = 1 presses with 2 and has no gap.
TEST_CASE("ex19.2 the term is consistent: at the solution it is the contact force", "[ex19.2]") {
  const ex19_2::Point bar{one(2), one(1), -1, 1};  // q(u) = 2 u, for u that opens the gap
  for (const double theta : {1.0, 0.0, -1.0}) {
    CAPTURE(theta);
    CHECK(ex19_2::nitsche_term(bar, one(1), 5, theta).force(0) == Approx(-2).epsilon(1e-14));
  }
}

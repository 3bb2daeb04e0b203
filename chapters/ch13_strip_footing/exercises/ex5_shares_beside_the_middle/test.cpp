#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using Eigen::VectorXd;
using ex13_5::shares;

// Five nodes on a strip of half-width 1: shares end at -1, -3/4, -1/4, 1/4, 3/4, 1.
static VectorXd five(double eccentricity) {
  return shares({1, 3, eccentricity}, VectorXd::LinSpaced(5, -1, 1));
}

TEST_CASE("ex13.5 a load in the middle is shared as before", "[ex13.5]") {
  const VectorXd share = five(0);
  CHECK(share.sum() == Approx(3).epsilon(1e-14));
  CHECK(equal_within(share, share.reverse(), 1e-14));
  CHECK(shares({2, 6}, Eigen::Vector3d(-2, 0, 2))(1) == Approx(2).epsilon(1e-14));  // a third
}

TEST_CASE("ex13.5 the shares add up to the load, wherever it acts", "[ex13.5]") {
  for (const double e : {-0.9, -0.5, 0.1, 0.5, 0.6, 0.99}) {
    CAPTURE(e);
    CHECK(five(e).sum() == Approx(3).epsilon(1e-13));
    CHECK(five(e).minCoeff() >= 0);
  }
}

// P 2 e / (pi a^2) times the integral of x / sqrt(a^2 - x^2) from 1/4 to 3/4, once more and once less.
TEST_CASE("ex13.5 beside the middle one side bears more", "[ex13.5]") {
  const VectorXd share = five(0.25);
  const double integral = std::sqrt(15.0 / 16) - std::sqrt(7.0 / 16);
  CHECK(share(3) - share(1) == Approx(2 * 3 * 0.5 / std::acos(-1.0) * integral).epsilon(1e-12));
  CHECK(share(2) == Approx(five(0)(2)).epsilon(1e-13));
}

TEST_CASE("ex13.5 beyond half of a the far edge bears nothing", "[ex13.5]") {
  const VectorXd share = five(0.75);  // bears from 0 to 1
  CHECK(share(0) == 0);
  CHECK(share(1) == 0);
  CHECK(share(2) > 0);
  CHECK_THROWS_AS(five(1), std::invalid_argument);
}

TEST_CASE("ex13.5 a load on the other side is a mirror image", "[ex13.5]") {
  for (const double e : {0.25, 0.75}) CHECK(equal_within(five(-e), five(e).reverse(), 1e-13));
  CHECK_THROWS_AS(five(-1), std::invalid_argument);
}

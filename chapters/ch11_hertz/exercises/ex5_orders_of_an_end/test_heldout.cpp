#include <cmath>
#include <limits>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex11_5;

// The integrals of hint 1 and 2 summed, not thought about: the slope of the root of the sum between two sizes of cells.
static double slope_of(double smooth, double power, bool root) {
  const auto sum = [&](double h) {  // h^smooth times the integral of r^power from h to 1
    const int steps = 200000;
    double all = 0;
    for (int k = 0; k < steps; ++k) {
      const double r = std::pow(h, (k + 0.5) / steps);
      all += std::pow(r, power + 1) * -std::log(h) / steps;
    }
    return std::pow(h, smooth) * all;
  };
  return std::log2(sum(1e-6) / sum(0.5e-6)) / (root ? 2 : 1);
}

TEST_CASE("ex11.5 held out: as the integrals say, for any powers", "[ex11.5]") {
  for (const int p : {1, 2, 3})
    for (const double a : {0.55, 0.8, 1.25, 1.7, 2.3}) {
      CAPTURE(p, a);
      const Orders all = orders(a, 0.6, p);
      // up to 0.06 from terms that are not gone at h = 1e-6
      CHECK(all.energy == Approx(slope_of(2 * p, 2 * (a - 1 - p) + 1, true)).margin(0.06));
      CHECK(all.pressure == Approx(slope_of(2 * p, 2 * (a - 1 - p), true)).margin(0.06));
      CHECK(all.integral == Approx(slope_of(2 * p, a + 0.6 - 2 - 2 * p + 1, false)).margin(0.06));
    }
}

TEST_CASE("ex11.5 held out: a smooth solution has the orders of the degree", "[ex11.5]") {
  CHECK(orders(9, 9, 2).energy == 2);
  CHECK(orders(9, 9, 2).pressure == 2);
  CHECK(orders(9, 9, 2).integral == 4);
}

TEST_CASE("ex11.5 held out: powers and parts out of range are refused", "[ex11.5]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(orders(0, 0.5, 1), std::invalid_argument);
  CHECK_THROWS_AS(orders(1.5, nan, 1), std::invalid_argument);
  CHECK_THROWS_AS(times_more_cells(0, 1), std::invalid_argument);
  CHECK_THROWS_AS(times_more_cells(1.5, 1), std::invalid_argument);
  CHECK_THROWS_AS(times_more_cells(0.1, 0), std::invalid_argument);
  CHECK(times_more_cells(1, 0.7) == 1);
}

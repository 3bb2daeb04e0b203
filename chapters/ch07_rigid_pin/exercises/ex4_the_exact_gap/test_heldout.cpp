#include <cmath>
#include <limits>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex7_4;

// For a tiny clearance the gap is epsilon (1 - cos theta), to as many digits as epsilon is small.
TEST_CASE("ex7.4 held out: tiny clearances keep their digits", "[ex7.4]") {
  for (const double size : {1e-10, 1e-12, 1e-15})
    for (const double theta : {1e-4, 1e-2, 0.5, 1.5}) {
      CAPTURE(size, theta);
      const double expected = 2 * size * std::pow(std::sin(theta / 2), 2);
      CHECK(gap_at({5, size, size}, theta).gap == Approx(expected).epsilon(1e-9));
    }
}

// Circles about one point: the gap is the clearance everywhere.
TEST_CASE("ex7.4 held out: no shift", "[ex7.4]") {
  for (const double clearance : {-0.3, 0.0, 1e-13, 2.0})
    for (const double theta : {0.0, 1.0, 4.0}) {
      const Gap at = gap_at({3, clearance, 0}, theta);
      CHECK(at.gap == Approx(clearance).epsilon(1e-13).margin(1e-300));
      CHECK(at.nx == Approx(std::cos(theta)).margin(1e-15));
    }
}

TEST_CASE("ex7.4 held out: large shifts, both ways, against plain distances", "[ex7.4]") {
  for (const double shift : {-2.9, -1.0, 0.5, 2.9})
    for (const double clearance : {-1.0, 0.4, 2.5})
      for (const double theta : {0.0, 0.7, 2.0, 3.1, 5.0}) {
        CAPTURE(shift, clearance, theta);
        const double plain =
            std::hypot(3 * std::cos(theta) - shift, 3 * std::sin(theta)) - (3 - clearance);
        CHECK(gap_at({3, clearance, shift}, theta).gap == Approx(plain).margin(1e-13));
        CHECK(gap_at({3, clearance, shift}, -theta).gap == Approx(plain).margin(1e-13));
      }
}

TEST_CASE("ex7.4 held out: units of length do not matter", "[ex7.4][units]") {
  for (const double unit : {1e-9, 1e9}) {
    const Gap one = gap_at({5, 0.2, 0.3}, 1), other = gap_at({5 * unit, 0.2 * unit, 0.3 * unit}, 1);
    CHECK(other.gap == Approx(one.gap * unit).epsilon(1e-13));
    CHECK(other.nx == Approx(one.nx).epsilon(1e-13));
  }
}

TEST_CASE("ex7.4 held out: what is no pin in a hole is refused", "[ex7.4]") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double much = std::numeric_limits<double>::infinity();
  for (const Fit& bad :
       {Fit{0, -1, 0}, Fit{-5, -6, 0}, Fit{5, 5, 0}, Fit{5, 0.1, 5}, Fit{5, 0.1, -5},
        Fit{none, 0, 0}, Fit{5, none, 0}, Fit{5, -much, 0}, Fit{5, 0.1, none}})
    CHECK_THROWS_AS(gap_at(bad, 1), std::invalid_argument);
  CHECK_THROWS_AS(gap_at({5, 0.1, 0.1}, much), std::invalid_argument);
}

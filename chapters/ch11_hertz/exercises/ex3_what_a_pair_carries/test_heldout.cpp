#include <cmath>
#include <limits>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex11_3;

TEST_CASE("ex11.3 held out: right numbers are explained at any number of digits", "[ex11.3]") {
  const Contact contact{1.7, 3.1, 900};
  const double pi = std::acos(-1.0);
  const double b = std::sqrt(4 * contact.load * contact.radius / (pi * contact.modulus));
  const double q = std::sqrt(contact.load * contact.modulus / (pi * contact.radius));
  for (const int b_digits : {1, 2, 5, 8})
    for (const int q_digits : {0, 1, 3}) {
      const double b_unit = std::pow(10, -b_digits), q_unit = std::pow(10, -q_digits);
      const Printed row{b_unit * std::round(b / b_unit), b_digits, q_unit * std::round(q / q_unit),
                        q_digits};
      CAPTURE(b_digits, q_digits);
      CHECK(is_rounding(row, contact.load));
      CHECK_FALSE(
          is_rounding({row.half_width + 1.1 * b_unit, b_digits, row.peak + 1.1 * q_unit, q_digits},
                      contact.load));
      if (row.half_width > 2 * b_unit)
        CHECK_FALSE(is_rounding(
            {row.half_width - 1.1 * b_unit, b_digits, row.peak - 1.1 * q_unit, q_digits},
            contact.load));
    }
}

// One number too large and the other too small may carry the load together.
TEST_CASE("ex11.3 held out: each number has its own last digit", "[ex11.3]") {
  const double load = std::acos(-1.0) / 2;  // of 1 and 1
  CHECK(is_rounding({1.04, 2, 1, 0}, load));
  CHECK_FALSE(is_rounding({1, 0, 2.1, 1}, load));
  CHECK(is_rounding({1, 0, 1.9, 1}, load));
  CHECK_FALSE(is_rounding({1.02, 2, 1.00, 2}, load));
  CHECK(is_rounding({1.02, 2, 0.98, 2}, load));
}

TEST_CASE("ex11.3 held out: units of length and force do not matter", "[ex11.3]") {
  const Printed row{2, 1, 30, 0};
  const Contact contact{90, 70, 2500};
  for (const double length : {1e-3, 1e3})
    for (const double force : {1e-6, 1e6}) {
      const double stress = force / (length * length);
      const Printed other{row.half_width * length, 0, row.peak * stress, 0};
      const Contact there{contact.load * force / length, contact.radius * length,
                          contact.modulus * stress};
      CHECK(pi_in_half_width(other, there) ==
            Approx(pi_in_half_width(row, contact)).epsilon(1e-12));
      CHECK(pi_in_peak(other, there) == Approx(pi_in_peak(row, contact)).epsilon(1e-12));
      CHECK(carried(other) == Approx(carried(row) * force / length).epsilon(1e-12));
    }
}

TEST_CASE("ex11.3 held out: what is no row or no contact is refused", "[ex11.3]") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double much = std::numeric_limits<double>::infinity();
  const Contact contact{1, 1, 1};
  for (const Printed& row : {Printed{0, 1, 1, 1}, Printed{1, 1, -1, 1}, Printed{none, 1, 1, 1},
                             Printed{1, 1, much, 1}, Printed{1, -1, 1, 1}, Printed{1, 1, 1, -1}}) {
    CHECK_THROWS_AS(carried(row), std::invalid_argument);
    CHECK_THROWS_AS(is_rounding(row, 1), std::invalid_argument);
    CHECK_THROWS_AS(pi_in_half_width(row, contact), std::invalid_argument);
    CHECK_THROWS_AS(pi_in_peak(row, contact), std::invalid_argument);
  }
  CHECK_THROWS_AS(is_rounding({1, 1, 1, 1}, 0), std::invalid_argument);
  for (const Contact& bad : {Contact{0, 1, 1}, Contact{1, none, 1}, Contact{1, 1, -1}}) {
    CHECK_THROWS_AS(pi_in_half_width({1, 1, 1, 1}, bad), std::invalid_argument);
    CHECK_THROWS_AS(pi_in_peak({1, 1, 1, 1}, bad), std::invalid_argument);
  }
}

#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex11_3;

// Table 2 of Lin et al., and the contact of table 1.
static const Contact table_1{41.76, 50, 4000 / (2 * (1 - 0.35 * 0.35))};
static const Printed theory{1.08000, 5, 24.6219, 4};
static const Printed paper{1.09957, 5, 23.8437, 4};
static const Printed abaqus{1.11780, 5, 23.4287, 4};

TEST_CASE("ex11.3 the load is the area under the ellipse", "[ex11.3]") {
  for (const Printed& row : {theory, paper, abaqus}) {
    double sum = 0;  // by midpoints
    const int n = 20000;
    for (int k = 0; k < n; ++k) {
      const double s = (k + 0.5) * 2 / n - 1;
      sum += row.peak * std::sqrt(1 - s * s) * row.half_width * 2 / n;
    }
    CHECK(carried(row) == Approx(sum).epsilon(1e-5));
  }
}

TEST_CASE("ex11.3 with the numbers that are found, (43) prints what is printed",
          "[ex11.3][LinEtAl-43]") {
  const auto& [P, R, E] = table_1;
  for (const Printed& row : {theory, paper, abaqus}) {
    const double in_b = pi_in_half_width(row, table_1), in_q = pi_in_peak(row, table_1);
    CHECK(std::sqrt(4 * P * R / (in_b * E)) == Approx(row.half_width).epsilon(1e-12));
    CHECK(std::sqrt(P * E / (in_q * R)) == Approx(row.peak).epsilon(1e-12));
  }
}

TEST_CASE("ex11.3 one of the two numbers of the theory has a pi of two decimals", "[ex11.3]") {
  const double in_b = pi_in_half_width(theory, table_1), in_q = pi_in_peak(theory, table_1);
  const double pi = std::acos(-1.0);
  const auto short_pi = [](double x) { return std::abs(x - 3.14) < 5e-5; };
  CHECK(short_pi(in_b) != short_pi(in_q));
  CHECK(std::abs(in_b - pi) + std::abs(in_q - pi) < 2e-3);
}

// What pi explains is no rounding; right numbers, rounded, are.
TEST_CASE("ex11.3 print cannot explain any of the printed rows", "[ex11.3]") {
  for (const Printed& row : {theory, paper, abaqus}) CHECK_FALSE(is_rounding(row, table_1.load));
  CHECK(is_rounding({1.08001, 5, 24.6157, 4}, table_1.load));
  CHECK(is_rounding({1.1, 1, 24, 0}, table_1.load));
  CHECK(is_rounding({1.0, 1, 24.6157, 4}, 40.2));         // 1.04 and 24.6157 carry it
  CHECK(is_rounding({1.08001, 5, 25, 0}, table_1.load));  // too much, but for the peak's last digit
  CHECK(is_rounding({1.08001, 5, 24.6, 1}, table_1.load));  // too little, but for that
}

TEST_CASE("ex11.3 a number that is not positive is refused", "[ex11.3]") {
  CHECK_THROWS_AS(carried({0, 5, 24.6219, 4}), std::invalid_argument);
}

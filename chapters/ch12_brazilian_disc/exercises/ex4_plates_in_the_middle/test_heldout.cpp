#include <cmath>
#include <limits>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using ex12_4::middle_loss;

// Terms of the series in x / R: a chord loses 9/2 s - 15/8 s^2 - ..., and the means of s and s^2 are b^2 / 4 and b^4 / 8.
TEST_CASE("ex12.4 held out: losses of any smallness keep their digits", "[ex12.4]") {
  for (const double b : {1e-3, 1e-5, 1e-8, 1e-12}) {
    CAPTURE(b);
    const double expected = 1.125 * b * b - 15.0 / 64 * b * b * b * b;
    CHECK(middle_loss(1, b, 16) == Approx(expected).epsilon(1e-12));
  }
}

// By midpoints of the integral over the strip, with as many as it takes.
TEST_CASE("ex12.4 held out: wide loads, also where the middle is pressed", "[ex12.4]") {
  for (const double b : {0.25, 0.6, 0.9, 1.0}) {
    double tension = 0, all = 0;
    const int n = 200000;
    for (int k = 0; k < n; ++k) {
      const double x = (2 * k + 1.0) / n - 1, share = std::sqrt(1 - x * x);
      const double s = b * b * x * x;
      tension += share * std::sqrt(1 - s) * (1 - 4 * s);
      all += share;
    }
    CAPTURE(b);
    CHECK(middle_loss(1, b, 400) == Approx(1 - tension / all).epsilon(1e-6));
  }
}

TEST_CASE("ex12.4 held out: the unit of length does not matter", "[ex12.4][units]") {
  for (const double unit : {1e-9, 1e9})
    CHECK(middle_loss(50 * unit, 3 * unit, 20) == Approx(middle_loss(50, 3, 20)).epsilon(1e-12));
}

TEST_CASE("ex12.4 held out: few chords stand for all, too", "[ex12.4]") {
  CHECK(middle_loss(1, 0.1, 3) == Approx(middle_loss(1, 0.1, 100)).epsilon(1e-6));
  CHECK(middle_loss(1, 0.1, 4) == Approx(middle_loss(1, 0.1, 100)).epsilon(1e-8));
}

TEST_CASE("ex12.4 held out: what is no load is refused", "[ex12.4]") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(middle_loss(0, 0, 16), std::invalid_argument);
  CHECK_THROWS_AS(middle_loss(-1, 0, 16), std::invalid_argument);
  CHECK_THROWS_AS(middle_loss(none, 0, 16), std::invalid_argument);
  CHECK_THROWS_AS(middle_loss(std::numeric_limits<double>::infinity(), 1, 16),
                  std::invalid_argument);
  CHECK_THROWS_AS(middle_loss(1, -0.1, 16), std::invalid_argument);
  CHECK_THROWS_AS(middle_loss(1, 1.1, 16), std::invalid_argument);
  CHECK_THROWS_AS(middle_loss(1, none, 16), std::invalid_argument);
  CHECK_THROWS_AS(middle_loss(1, 0.1, 0), std::invalid_argument);
}

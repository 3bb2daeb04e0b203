#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/random.hpp"
#include "signorini/problem/complementarity_functions.hpp"

using ex8_1::Slope;
using signorini::fischer_burmeister;

TEST_CASE("ex8.1 held out: the slope agrees with central differences", "[ex8.1]") {
  signorini::Random random(8);
  for (int sample = 0; sample < 200; ++sample) {
    const double a = random.uniform(-2, 2);
    const double b = random.uniform(-2, 2);
    CAPTURE(a, b);
    const double h = 1e-5 * std::hypot(a, b);  // differences are wrong by 1e-10 of the slope
    const Slope at = ex8_1::slope(a, b);
    const double of_a = fischer_burmeister(a + h, b) - fischer_burmeister(a - h, b);
    const double of_b = fischer_burmeister(a, b + h) - fischer_burmeister(a, b - h);
    CHECK(of_a / (2 * h) == Approx(at.a).margin(1e-8));
    CHECK(of_b / (2 * h) == Approx(at.b).margin(1e-8));
  }
}

// The two values plus (1, 1) are cosine and sine of a direction.
TEST_CASE("ex8.1 held out: every slope lies on a circle, whatever the size of the arguments",
          "[ex8.1]") {
  signorini::Random random(9);
  for (const double size : {1e-300, 1e-160, 1.0, 1e160, 1e300})
    for (int sample = 0; sample < 20; ++sample) {
      const double a = random.uniform(-1, 1);
      const double b = random.uniform(-1, 1);
      CAPTURE(size, a, b);
      const Slope at = ex8_1::slope(size * a, size * b);
      CHECK(std::hypot(at.a + 1, at.b + 1) == Approx(1).epsilon(1e-14));
      CHECK(at.a == Approx(ex8_1::slope(a, b).a).epsilon(1e-13));
    }
}

TEST_CASE("ex8.1 held out: digits near both axes, and where both numbers are negative", "[ex8.1]") {
  CHECK(ex8_1::slope(1e-10, 1).b == Approx(-5e-21).epsilon(1e-12).margin(0));
  CHECK(ex8_1::slope(-1, 1e-10).a == Approx(-2).epsilon(1e-15));
  CHECK(ex8_1::slope(-3, -4).a == Approx(-1.6).epsilon(1e-15));
  CHECK(ex8_1::slope(-3, -4).b == Approx(-1.8).epsilon(1e-15));
}

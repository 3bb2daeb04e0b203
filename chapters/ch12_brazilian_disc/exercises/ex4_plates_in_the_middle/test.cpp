#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using ex12_4::middle_loss;

TEST_CASE("ex12.4 the disc of the chapter", "[ex12.4][LinEtAl-44]") {
  CHECK(100 * middle_loss(50, 1.08001, 1000) == Approx(0.0525).margin(5e-5));
}

// The mean of x^2 under the ellipse is b^2 / 4, and a chord loses 9/2 (x / R)^2.
TEST_CASE("ex12.4 narrow loads lose 9/8 of the square of the width", "[ex12.4]") {
  for (const double b : {0.1, 0.01, 0.001, 1e-7})
    CHECK(middle_loss(1, b, 1000) == Approx(1.125 * b * b).epsilon(3 * b * b + 1e-4));
}

TEST_CASE("ex12.4 a load on a line loses nothing", "[ex12.4]") {
  CHECK(middle_loss(50, 0, 16) == 0);
}

TEST_CASE("ex12.4 sixteen chords are as good as a thousand", "[ex12.4]") {
  for (const double b : {0.25, 0.1})
    CHECK(middle_loss(1, b, 16) == Approx(middle_loss(1, b, 1000)).epsilon(1e-9));
}

TEST_CASE("ex12.4 a width above the radius is refused", "[ex12.4]") {
  CHECK_THROWS_AS(middle_loss(1, 1.1, 16), std::invalid_argument);
}

// What the page says of a chord, summed up: ten digits are left of the differences.
TEST_CASE("ex12.4 wide loads, chord by chord", "[ex12.4]") {
  for (const double b : {0.25, 0.6, 0.95}) {
    double sum = 0, shares = 0;
    for (int k = 0; k < 100000; ++k) {
      const double x = b * ((k + 0.5) / 50000 - 1), share = std::sqrt(1 - x * x / (b * b));
      sum += share * (1 - std::sqrt(1 - x * x) * (1 - 4 * x * x));
      shares += share;
    }
    CAPTURE(b);
    CHECK(middle_loss(1, b, 1000) == Approx(sum / shares).epsilon(1e-6));
  }
}

#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"

using ex8_1::Slope;

TEST_CASE("ex8.1 a triangle with sides 3, 4 and 5", "[ex8.1]") {
  const Slope at = ex8_1::slope(3, 4);
  CHECK(at.a == Approx(3.0 / 5 - 1).epsilon(1e-15));
  CHECK(at.b == Approx(4.0 / 5 - 1).epsilon(1e-15));
}

TEST_CASE("ex8.1 a pair that is open or closed has the slope of one number only",
          "[ex8.1][LinEtAl-12]") {
  CHECK(ex8_1::slope(2, 0).a == 0);
  CHECK(ex8_1::slope(2, 0).b == Approx(-1).epsilon(1e-15));
  CHECK(ex8_1::slope(0, 2).a == Approx(-1).epsilon(1e-15));
  CHECK(ex8_1::slope(0, 2).b == 0);
}

TEST_CASE("ex8.1 at the kink the slope is the one along a = b", "[ex8.1]") {
  const Slope kink = ex8_1::slope(0, 0);
  CHECK(kink.a == Approx(std::sqrt(0.5) - 1).epsilon(1e-15));
  CHECK(kink.b == Approx(std::sqrt(0.5) - 1).epsilon(1e-15));
}

TEST_CASE("ex8.1 near an axis the slope keeps its digits", "[ex8.1]") {
  CHECK(ex8_1::slope(1, 1e-10).a == Approx(-5e-21).epsilon(1e-12).margin(0));
}

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex22_1;

TEST_CASE("ex22.1 held out: a small way keeps its digits", "[ex22.1]") {
  // s^2/2R, of which the next term takes a part of s^2/4R^2
  CHECK(error_of_linear_gap(1e-9, 1) == Approx(5e-19).epsilon(1e-14));
  CHECK(error_of_linear_gap(1e-6, 100) == Approx(5e-15).epsilon(1e-14));
}

TEST_CASE("ex22.1 held out: the way undoes the error", "[ex22.1]") {
  for (const double allowed : {1e-12, 1e-3, 1.0, 50.0})
    for (const double radius : {0.5, 10.0}) {
      CAPTURE(allowed, radius);
      CHECK(error_of_linear_gap(longest_way(allowed, radius), radius) ==
            Approx(allowed).epsilon(1e-13));
    }
}

// A quarter of the error takes twice as many stretches.
TEST_CASE("ex22.1 held out: errors fall with the square", "[ex22.1]") {
  CHECK(stretches(5, 0.00025, 10) == 71);
  CHECK(stretches(5, 0.0000625, 10) == 142);
  CHECK(stretches(8.0001, 2, 3) == 3);
  CHECK(stretches(7.9999, 2, 3) == 2);
}

#include <cmath>
#include <limits>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using ex19_3::read_sweep;

TEST_CASE("ex19.3 held out: an error that touches the floor and rises again", "[ex19.3]") {
  CHECK(read_sweep({{1, 0.1, 1}, {2, 0.2, 1}, {3, 0.105, 1}, {4, 0.109, 1}}).enough == 3);
  CHECK(read_sweep({{1, 0.1, 1}, {2, 0.1, 1}, {3, 0.2, 1}}).enough == HUGE_VAL);
}

TEST_CASE("ex19.3 held out: the order of uneven steps, and one that falls", "[ex19.3]") {
  CHECK(read_sweep({{1, 1, 1}, {2, 1, 7}, {6, 1, 63}}).order == Approx(2).epsilon(1e-14));
  CHECK(read_sweep({{1, 1, 8}, {4, 1, 4}}).order == Approx(-0.5).epsilon(1e-14));
}

TEST_CASE("ex19.3 held out: rows that are none", "[ex19.3]") {
  CHECK_THROWS_AS(read_sweep({{1, 1, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(read_sweep({{2, 1, 1}, {1, 1, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(read_sweep({{1, 1, 1}, {2, 0, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(read_sweep({{1, 1, 1}, {2, 1, -3}}), std::invalid_argument);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(read_sweep({{1, 1, 1}, {2, nan, 3}}), std::invalid_argument);
}

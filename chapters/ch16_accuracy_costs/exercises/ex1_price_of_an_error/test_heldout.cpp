#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex16_1;

TEST_CASE("ex16.1 held out: all points count, not the first and the last", "[ex16.1]") {
  const std::vector<Point> line = {{1, 1}, {10, 1}, {100, 0.01}};
  CHECK(order(line) == Approx(1).epsilon(1e-12));
  const std::vector<Point> bent = {{1, 1}, {10, 0.01}, {100, 0.01}, {1000, 0.001}};
  CHECK(order(bent) == Approx(0.9).epsilon(1e-12));
}

TEST_CASE("ex16.1 held out: neither order nor units of the points matter", "[ex16.1]") {
  const double there = order({{2, 5}, {3, 4}, {8, 1}});
  CHECK(order({{8e3, 0.01}, {2e3, 0.05}, {3e3, 0.04}}) == Approx(there).epsilon(1e-12));
}

TEST_CASE("ex16.1 held out: an error that grows has no price", "[ex16.1]") {
  CHECK(order({{1, 1}, {2, 2}}) == Approx(-1).epsilon(1e-12));
  CHECK(price({{1, 1}, {2, 2}}, 10) == HUGE_VAL);
}

TEST_CASE("ex16.1 held out: what is no line is refused", "[ex16.1]") {
  CHECK_THROWS_AS(order({{1, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(order({{1, 1}, {1, 2}}), std::invalid_argument);
  CHECK_THROWS_AS(order({{1, 1}, {2, 0}}), std::invalid_argument);
  CHECK_THROWS_AS(price({{1, 2}, {2, 1}}, 1), std::invalid_argument);
}

#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex16_1;

TEST_CASE("ex16.1 order h at a cost of h^-3: a digit costs a thousand", "[ex16.1]") {
  std::vector<Point> line;
  for (const double h : {1.0, 0.5, 0.25, 0.125}) line.push_back({std::pow(h, -3), 7 * h});
  CHECK(order(line) == Approx(1.0 / 3).epsilon(1e-12));
  CHECK(price(line, 10) == Approx(1000).epsilon(1e-11));
  CHECK(price(line, 2) == Approx(8).epsilon(1e-11));
}

TEST_CASE("ex16.1 a line that is flat has no price", "[ex16.1]") {
  CHECK(price({{1, 2}, {10, 2}, {100, 2}}, 10) == HUGE_VAL);
}

TEST_CASE("ex16.1 one point is no line", "[ex16.1]") {
  CHECK_THROWS_AS(order({{8, 0.1}}), std::invalid_argument);
  CHECK_THROWS_AS(price({{1, 1}, {8, 0.1}}, 0.5), std::invalid_argument);
}

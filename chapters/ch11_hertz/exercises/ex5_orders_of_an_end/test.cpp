#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex11_5;

TEST_CASE("ex11.5 Hertz: quadratic elements gain half an order in energy and nothing else", "[ex11.5]") {
  const Orders linear = orders(1.5, 0.5, 1), quadratic = orders(1.5, 0.5, 2);
  CHECK(linear.energy == 1);
  CHECK(quadratic.energy == 1.5);
  CHECK(linear.pressure == 1);
  CHECK(quadratic.pressure == 1);
  CHECK(linear.integral == 2);
  CHECK(quadratic.integral == 2);
}

TEST_CASE("ex11.5 the footing: no degree helps", "[ex11.5]") {
  for (const int degree : {1, 2, 3}) {
    CHECK(orders(0.5, 0.5, degree).energy == 0.5);
    CHECK(orders(0.5, 0.5, degree).pressure == 0);
    CHECK(orders(0.5, 0.5, degree).integral == 1);
  }
}

TEST_CASE("ex11.5 what a tenth of the error takes", "[ex11.5]") {
  CHECK(times_more_cells(0.1, 1) == Approx(100).epsilon(1e-12));
  CHECK(times_more_cells(0.1, 1.5) == Approx(21.544).epsilon(1e-4));
  CHECK(times_more_cells(0.1, 0.5) == Approx(1e4).epsilon(1e-12));
}

TEST_CASE("ex11.5 a degree of nothing is refused", "[ex11.5]") {
  CHECK_THROWS_AS(orders(1.5, 0.5, 0), std::invalid_argument);
}

#include <cmath>
#include <limits>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex8_3;
using Residuals = std::vector<double>;

TEST_CASE("ex8.3 held out: the smallest period, and only if two rounds are there", "[ex8.3]") {
  CHECK(period({1, 2, 3, 1, 2, 3, 1, 2, 3}) == 3);
  CHECK(period({9, 1, 2, 3, 1, 2}) == 0);
  CHECK(period({1, 2, 3, 1, 2, 3}) == 3);
  CHECK(period({4, 4, 4, 4}) == 1);
  CHECK(period({8, 1, 2, 1, 2 + 1e-8}) == 0);
  CHECK(period({8, 1, 2, 1, 2 + 1e-10}) == 2);
  CHECK(fate({4, 4, 4, 4}) == Fate::Round);
}

TEST_CASE("ex8.3 held out: the unit of the residuals does not matter", "[ex8.3]") {
  for (const double unit : {1e-12, 1.0, 1e12}) {
    CHECK(fate({unit, 0.5 * unit, 0.25 * unit, 0.125 * unit}) == Fate::Steady);
    CHECK(steps_left({unit, 0.5 * unit, 0.25 * unit, 0.125 * unit}, 0.9e-3 * unit) == 8);
    CHECK(period({8 * unit, unit, 2 * unit, unit, 2 * unit}) == 2);
  }
}

// Gains of 1, 1.4, 2 are neither; 1, 1.5, 2.25 are quick; the middle step counts as well.
TEST_CASE("ex8.3 held out: the limits between the fates", "[ex8.3]") {
  const auto of_gains = [](double a, double b, double c) {
    return Residuals{1, std::pow(10, -a), std::pow(10, -a - b), std::pow(10, -a - b - c)};
  };
  CHECK(fate(of_gains(1, 1.4, 2)) == Fate::Unclear);
  CHECK(fate(of_gains(1, 1.51, 2.3)) == Fate::Quick);
  CHECK(fate(of_gains(1, 2, 2.1)) == Fate::Unclear);
  CHECK(fate(of_gains(2, 1, 2)) == Fate::Unclear);
  CHECK(fate(of_gains(1.05, 1, 1.08)) == Fate::Steady);
  CHECK(fate(of_gains(1.2, 1, 1.1)) == Fate::Unclear);
  CHECK(fate(of_gains(-1, -0.4, 2)) == Fate::Unclear);
  CHECK(fate({7, 7, 9, 1, 1e-1, 1e-2, 1e-3}) == Fate::Steady);  // the last ones count
}

TEST_CASE("ex8.3 held out: gains grow as they grew, and at most twice", "[ex8.3]") {
  const Residuals slow = {1, 1e-2, 1e-5, std::pow(10, -9.5)};  // gains of 2, 3 and 4.5
  CHECK(steps_left(slow, std::pow(10, -9.5 - 6.7)) == 1);      // the next is 6.75
  CHECK(steps_left(slow, std::pow(10, -9.5 - 6.8)) == 2);
  const Residuals fast = {1, 1e-1, 1e-3, 1e-13};  // 1, 2, 10: the next is 20
  CHECK(steps_left(fast, 1e-32) == 1);
  CHECK(steps_left(fast, 1e-34) == 2);
}

TEST_CASE("ex8.3 held out: what is there already needs no step", "[ex8.3]") {
  CHECK(steps_left({3, 2, 5, 2, 5}, 6) == 0);
  CHECK(steps_left({1, 1e-1, 1e-3, 0}, 1e-300) == 0);
  CHECK(fate({1, 1e-1, 1e-3, 0}) == Fate::Quick);
  CHECK(digits_gained({1, 1e-1, 1e-3, 0}).back() == HUGE_VAL);
  CHECK_FALSE(steps_left({3, 2, 5, 2, 5}, 1));
}

TEST_CASE("ex8.3 held out: what is no run is refused", "[ex8.3]") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const Residuals& bad :
       {Residuals{}, Residuals{1, 1, 1}, Residuals{1, 1, none, 1}, Residuals{1, -1, 1, 1},
        Residuals{1, 0, 1, 1}, Residuals{1, 1, 1, std::numeric_limits<double>::infinity()}}) {
    CHECK_THROWS_AS(digits_gained(bad), std::invalid_argument);
    CHECK_THROWS_AS(period(bad), std::invalid_argument);
    CHECK_THROWS_AS(fate(bad), std::invalid_argument);
    CHECK_THROWS_AS(steps_left(bad, 1), std::invalid_argument);
  }
  CHECK_THROWS_AS(steps_left({4, 3, 2, 1}, 0), std::invalid_argument);
  CHECK_THROWS_AS(steps_left({4, 3, 2, 1}, none), std::invalid_argument);
}

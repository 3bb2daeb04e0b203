#include <cmath>
#include <limits>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/random.hpp"

using namespace ex13_4;

TEST_CASE("ex13.4 held out: any order, any limit, from either side or in turns", "[ex13.4]") {
  signorini::Random random(13);
  for (int sample = 0; sample < 200; ++sample) {
    const double limit = random.uniform(-5, 5), error = random.uniform(1, 2);
    const double order = random.uniform(0.2, 4);
    const double sign = sample % 2 == 0 ? 1 : -1;
    const double turns = sample % 3 == 0 ? -1 : 1;
    std::vector<double> column;
    for (int row = 0; row < 5; ++row)
      column.push_back(limit + sign * error * std::pow(turns * std::exp2(-order), row));
    CAPTURE(limit, error, order, turns);
    const Trend trend = trend_of(column);
    CHECK(trend.fate == Fate::Converges);
    CHECK(trend.order == Approx(order).epsilon(1e-6));
    CHECK(trend.limit == Approx(limit).margin(1e-6));
    CHECK(trend.power == 0);
  }
}

TEST_CASE("ex13.4 held out: powers, down as well as up, in any unit", "[ex13.4]") {
  for (const double unit : {-1e-12, 1e-12, 1.0, 1e12})
    for (const double power : {1.0, 1.5, 2.0}) {
      CAPTURE(unit, power);
      const Trend trend = trend_of({unit, unit * std::exp2(power), unit * std::exp2(2 * power)});
      CHECK(trend.fate == Fate::Grows);
      CHECK(trend.power == Approx(power).epsilon(1e-12));
      CHECK(trend.limit == 0);
      CHECK(trend.order == 0);
    }
}

// The settlement on a soil that becomes twice as large: it grows by the same amount each time.
TEST_CASE("ex13.4 held out: equal steps are growth", "[ex13.4]") {
  CHECK(trend_of({1, 2, 3}).fate == Fate::Grows);
  CHECK(trend_of({1, 2, 3}).power == Approx(std::log2(1.5)).epsilon(1e-12));
  CHECK(trend_of({0, 2, 4}).fate == Fate::Grows);
  CHECK(trend_of({-4, -6, -8}).fate == Fate::Grows);
}

TEST_CASE("ex13.4 held out: only the last three rows count", "[ex13.4]") {
  CHECK(trend_of({1, 100, -3, 1, 2, 4}).fate == Fate::Grows);
  CHECK(trend_of({1, 2, 4, 8, 8, 8}).limit == 8);
}

TEST_CASE("ex13.4 held out: neither", "[ex13.4]") {
  CHECK(trend_of({1, -2, 4}).fate == Fate::Unclear);
  CHECK(trend_of({10, 8, 5}).fate == Fate::Unclear);  // falls, faster and faster
  CHECK(trend_of({-1, 1, 4}).fate == Fate::Unclear);  // has passed zero
  CHECK(trend_of({-4, -1, 3}).fate == Fate::Unclear);
  CHECK(trend_of({-1, 2, 6}).fate == Fate::Unclear);
  CHECK(trend_of({3, 3, 4}).fate == Fate::Unclear);  // began to move
  CHECK(trend_of({1, 0, 1}).fate == Fate::Unclear);
}

TEST_CASE("ex13.4 held out: what stands still has come to its limit", "[ex13.4]") {
  const Trend still = trend_of({7, 7, 7});
  CHECK(still.fate == Fate::Converges);
  CHECK(still.limit == 7);
  CHECK(still.order == HUGE_VAL);
  CHECK(trend_of({0, 0, 0}).fate == Fate::Converges);
  CHECK(trend_of({1, 3, 3}).limit == 3);
}

TEST_CASE("ex13.4 held out: what is no column is refused", "[ex13.4]") {
  const double no_number = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(trend_of({}), std::invalid_argument);
  CHECK_THROWS_AS(trend_of({no_number, 1, 2, 4}), std::invalid_argument);
  CHECK_THROWS_AS(trend_of({1, 2, std::numeric_limits<double>::infinity()}), std::invalid_argument);
}

#include <algorithm>
#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "reference/rosen_suzuki_table_1.hpp"

using ex5_4::Answers;
using ex5_4::answers;
using reference::RandomProgramme;
using reference::table_1;

static const double tick = 65536.0 / 1193182.0;  // [s]

static const RandomProgramme& line_of(int n, int m) {
  return *std::find_if(table_1.begin(), table_1.end(),
                       [=](const RandomProgramme& line) { return line.n == n && line.m == m; });
}

TEST_CASE("ex5.4 held out: what the clock shows", "[ex5.4]") {
  const Answers mine = answers();
  CHECK(mine.lemke_ticks == std::round(table_1[0].lemke_seconds / tick));
  CHECK(mine.paper_ticks == std::round(table_1[0].paper_seconds / tick));
  CHECK(mine.undecided ==
        std::count_if(table_1.begin(), table_1.end(), [](const RandomProgramme& line) {
          return std::abs(line.lemke_seconds - line.paper_seconds) < 2 * tick;
        }));
  CHECK(std::abs(mine.uncertainty - tick / line_of(20, 20).lemke_seconds) < 0.002);
}

TEST_CASE("ex5.4 held out: who gains, and how it grows", "[ex5.4]") {
  const Answers mine = answers();
  const auto gain = [](const RandomProgramme& line) {
    return line.lemke_seconds / line.paper_seconds;
  };
  const auto best = std::max_element(
      table_1.begin(), table_1.end(),
      [&](const RandomProgramme& a, const RandomProgramme& b) { return gain(a) < gain(b); });
  CHECK(mine.best_n == best->n);
  CHECK(mine.best_m == best->m);
  const double growth = line_of(50, 50).lemke_seconds / line_of(10, 10).lemke_seconds;
  CHECK(std::abs(mine.exponent - std::log(growth) / std::log(5.0)) < 0.02);
  CHECK(mine.above_one ==
        std::count_if(table_1.begin(), table_1.end(),
                      [](const RandomProgramme& line) { return line.ratio > 1; }));
}

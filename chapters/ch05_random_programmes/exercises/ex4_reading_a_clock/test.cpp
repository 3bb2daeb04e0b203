#include "catch_compat.hpp"
#include "exercise.hpp"
#include "reference/rosen_suzuki_table_1.hpp"

using ex5_4::Answers;
using ex5_4::answers;
using reference::RandomProgramme;
using reference::table_1;

static const double tick = 65536.0 / 1193182.0;  // [s]

TEST_CASE("ex5.4 ticks are whole, and less than a clock can show is nothing", "[ex5.4]") {
  const Answers mine = answers();
  CAPTURE(mine.lemke_ticks);
  const bool lemke_took_at_least_one = mine.lemke_ticks >= 1;
  CHECK(lemke_took_at_least_one);
  const double ratio = table_1[0].paper_seconds / table_1[0].lemke_seconds;
  CAPTURE(mine.paper_ticks, mine.lemke_ticks);
  const bool they_are_as_the_times = mine.paper_ticks > (ratio - 0.1) * mine.lemke_ticks &&
                                     mine.paper_ticks < (ratio + 0.1) * mine.lemke_ticks;
  CHECK(they_are_as_the_times);
  CAPTURE(mine.undecided);
  const bool some_lines_say_something = 0 < mine.undecided && mine.undecided < 12;
  CHECK(some_lines_say_something);
  CAPTURE(mine.uncertainty);
  const bool a_share_of_the_time = 0 < mine.uncertainty && mine.uncertainty < 1;
  CHECK(a_share_of_the_time);
}

TEST_CASE("ex5.4 the line with the largest gain is one where the paper's method is quicker",
          "[ex5.4]") {
  const Answers mine = answers();
  CAPTURE(mine.best_n, mine.best_m);
  bool quicker = false;
  for (const RandomProgramme& line : table_1)
    if (line.n == mine.best_n && line.m == mine.best_m)
      quicker = line.lemke_seconds - line.paper_seconds > 2 * tick;
  CHECK(quicker);
}

TEST_CASE("ex5.4 the power leads from one size to the next", "[ex5.4]") {
  const Answers mine = answers();
  CHECK(mine.exponent > 2);  // more than the table of n x n entries
  CAPTURE(mine.above_one);
  const bool not_all_ratios_are_above_one = 0 < mine.above_one && mine.above_one < 12;
  CHECK(not_all_ratios_are_above_one);
}

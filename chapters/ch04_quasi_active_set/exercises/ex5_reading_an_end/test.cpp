#include <algorithm>
#include <cmath>

#include "../chapters/ch04_quasi_active_set/cases.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using ex4_5::Answers;
using ex4_5::answers;

static const exact::Programme& q = ch04::four_walls;

TEST_CASE("ex4.5 the answers fit each other", "[ex4.5]") {
  const Answers mine = answers();
  REQUIRE_FALSE(mine.overlapping.empty());
  for (const int row : mine.overlapping) {
    const bool is_a_row = 1 <= row && row <= 4;
    CHECK(is_a_row);
  }
  const bool the_least_energy_lies_between_the_two = mine.at_least < mine.at_most;
  CHECK(the_least_energy_lies_between_the_two);
  const bool no_more_is_lost_than_lies_between = mine.lost <= mine.at_most - mine.at_least;
  CHECK(no_more_is_lost_than_lies_between);
  const bool what_pulls_is_not_what_is_missing = mine.pulling != mine.missing;
  CHECK(what_pulls_is_not_what_is_missing);
}

// A point of less energy than the least one is not admissible, and the other way round.
TEST_CASE("ex4.5 the answers fit the walls", "[ex4.5]") {
  const Answers mine = answers();
  const exact::Vector end = {1, 1, 1};
  REQUIRE((1 <= mine.pulling && mine.pulling <= 4 && 1 <= mine.missing && mine.missing <= 4));
  const bool what_pulls_is_closed_at_35 =
      gap(q, static_cast<std::size_t>(mine.pulling - 1), end) == 0;
  CHECK(what_pulls_is_closed_at_35);
  const bool what_is_missing_is_open_at_35 =
      !(gap(q, static_cast<std::size_t>(mine.missing - 1), end) == 0);
  CHECK(what_is_missing_is_open_at_35);
  const double best = energy(q, closest(q, {0, 1, 2, 3}, q.p).u).value();
  const bool the_bounds_hold = mine.at_least < best && best < mine.at_most;
  CHECK(the_bounds_hold);
}

TEST_CASE("ex4.5 a pair of steps halves eta", "[ex4.5]") {
  const double halvings = -std::log2(answers().eta_20);
  const bool a_power_of_a_half = std::abs(halvings - std::round(halvings)) < 1e-6 && halvings > 2;
  CHECK(a_power_of_a_half);
}

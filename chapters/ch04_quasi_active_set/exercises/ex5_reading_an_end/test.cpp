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
    CHECK(1 <= row);
    CHECK(row <= 4);
  }
  CAPTURE(mine.at_least, mine.at_most);
  const bool the_least_energy_lies_between_the_two = mine.at_least < mine.at_most;
  CHECK(the_least_energy_lies_between_the_two);
  CAPTURE(mine.lost, mine.at_most, mine.at_least);
  const bool no_more_is_lost_than_lies_between = mine.lost <= mine.at_most - mine.at_least;
  CHECK(no_more_is_lost_than_lies_between);
  CAPTURE(mine.pulling, mine.missing);
  const bool what_pulls_is_not_what_is_missing = mine.pulling != mine.missing;
  CHECK(what_pulls_is_not_what_is_missing);
}

// A point of less energy than the least one is not admissible, and the other way round.
TEST_CASE("ex4.5 the answers fit the walls", "[ex4.5]") {
  const Answers mine = answers();
  const exact::Vector end = {1, 1, 1};
  REQUIRE(1 <= mine.pulling);
  REQUIRE(mine.pulling <= 4);
  REQUIRE(1 <= mine.missing);
  REQUIRE(mine.missing <= 4);
  CAPTURE(mine.pulling);
  const bool what_pulls_is_closed_at_35 =
      gap(q, static_cast<std::size_t>(mine.pulling - 1), end) == 0;
  CHECK(what_pulls_is_closed_at_35);
  CAPTURE(mine.missing);
  const bool what_is_missing_is_open_at_35 =
      !(gap(q, static_cast<std::size_t>(mine.missing - 1), end) == 0);
  CHECK(what_is_missing_is_open_at_35);
  const double best = energy(q, closest(q, {0, 1, 2, 3}, q.p).u).value();
  CAPTURE(mine.at_least, mine.at_most);
  const bool the_bounds_hold = mine.at_least < best && best < mine.at_most;
  CHECK(the_bounds_hold);
}

// u = 0 is admissible and has the energy 0, so that a bound from above is not worth much if it is not below.
TEST_CASE("ex4.5 signs and sizes", "[ex4.5]") {
  const Answers mine = answers();
  CHECK(mine.at_most < 0);
  CHECK(mine.lost > 0);
  const exact::Vector u = closest(q, {2, 3}, q.p).u;
  double largest = 0;
  for (std::size_t i = 0; i < 4; ++i) largest = std::max(largest, -gap(q, i, u).value());
  CHECK(mine.largest_overlap == Approx(largest).epsilon(0.03));
}

TEST_CASE("ex4.5 a pair of steps halves eta", "[ex4.5]") {
  const double eta_20 = answers().eta_20, halvings = -std::log2(eta_20);
  CAPTURE(eta_20, halvings);
  const bool a_power_of_a_half = std::abs(halvings - std::round(halvings)) < 1e-6 && halvings > 2;
  CHECK(a_power_of_a_half);
}

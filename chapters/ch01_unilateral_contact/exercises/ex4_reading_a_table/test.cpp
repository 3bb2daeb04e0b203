#include "../chapters/ch01_unilateral_contact/block_on_obstacle.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/scene/readings.hpp"

using namespace ex1_4;

TEST_CASE("ex1.4 the answers fit each other", "[ex1.4]") {
  const Answers mine = answers();
  CAPTURE(mine.overlapping, mine.closed);
  const bool whole_base_is_symmetric = mine.overlapping % 2 == 1 && mine.closed % 2 == 1;
  CHECK(whole_base_is_symmetric);
  CAPTURE(mine.closed, mine.overlapping);
  const bool not_all_that_overlap_are_closed = 0 < mine.closed && mine.closed < mine.overlapping;
  CHECK(not_all_that_overlap_are_closed);
  CAPTURE(mine.sets, mine.overlapping);
  const bool each_pair_doubles_the_sets = mine.sets == 1 << mine.overlapping;
  CHECK(each_pair_doubles_the_sets);
  CAPTURE(mine.open_at, mine.closed_at);
  const bool contact_ends_between_two_nodes = mine.open_at - mine.closed_at == 5;
  CHECK(contact_ends_between_two_nodes);
}

TEST_CASE("ex1.4 the answers fit a finer mesh", "[ex1.4]") {
  const Answers mine = answers();
  const signorini::SolvedScene finer = signorini::solved(ch01::block_on_obstacle(40), "the block");
  const double force = finer.solution.contact.force.sum();
  const double peak = finer.solution.pressure.maxCoeff();
  const double half_width =
      0.5 * static_cast<double>(finer.solution.contact.active().size());  // of 1 mm
  CAPTURE(mine.total_force);
  const bool force_is_of_the_whole_base =
      0.95 * force < mine.total_force && mine.total_force < 1.05 * force;
  CHECK(force_is_of_the_whole_base);
  CAPTURE(mine.pressure);
  const bool pressure_is_near_the_peak = 0.9 * peak < mine.pressure && mine.pressure < 1.1 * peak;
  CHECK(pressure_is_near_the_peak);
  CAPTURE(mine.closed_at, mine.open_at);
  const bool contact_ends_there = mine.closed_at < half_width && half_width < mine.open_at;
  CHECK(contact_ends_there);
  CAPTURE(mine.lift);
  const bool contact_lifts = mine.lift > 0;
  CHECK(contact_lifts);
}

#include <cmath>

#include "../chapters/ch06_cantilever/scene.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using ex6_3::Answers;
using ex6_3::answers;

static const double load = ch06::paper.pressure * ch06::paper.length * ch06::paper.width;  // [kN]

TEST_CASE("ex6.3 foundation and clamp balance the load", "[ex6.3]") {
  const Answers mine = answers();
  CAPTURE(mine.force, mine.clamp_force);
  const bool forces_add_up_to_zero = std::abs(mine.force + mine.clamp_force - load) < 0.02;
  CHECK(forces_add_up_to_zero);
  CAPTURE(mine.place, mine.clamp_moment);
  const double moment = mine.force * mine.place + mine.clamp_moment;
  const bool moments_add_up_to_zero = std::abs(moment - 0.5 * ch06::paper.length * load) < 1;
  CHECK(moments_add_up_to_zero);
}

TEST_CASE("ex6.3 the force is that of the chapter, and acts where there is contact", "[ex6.3]") {
  const Answers mine = answers();
  CAPTURE(mine.force);
  const bool within_a_tenth_of_a_percent = std::abs(mine.force / ch06::total_force_2d - 1) < 0.001;
  CHECK(within_a_tenth_of_a_percent);
  CAPTURE(mine.first_closed, mine.place);
  const bool between_its_ends = mine.first_closed < mine.place && mine.place < ch06::paper.length;
  CHECK(between_its_ends);
  CAPTURE(mine.first_closed, mine.peak_at, mine.place);
  const bool the_peak_is_inside = mine.first_closed < mine.peak_at && mine.peak_at < mine.place;
  CHECK(the_peak_is_inside);
  const double mean = mine.force / (ch06::paper.length - mine.first_closed) / ch06::paper.width;
  CAPTURE(mine.peak);
  const bool the_peak_is_above_the_mean = mine.peak > mean && mine.peak < 2 * mean;
  CHECK(the_peak_is_above_the_mean);
}

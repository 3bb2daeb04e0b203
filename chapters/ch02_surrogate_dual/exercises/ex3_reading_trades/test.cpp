#include <cmath>

#include "../chapters/ch02_surrogate_dual/three_candidates.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using ex2_3::Answers;
using ex2_3::answers;

TEST_CASE("ex2.3 the answers fit each other", "[ex2.3]") {
  const Answers mine = answers();
  for (const double yield : mine.yield) {
    const bool a_pair_yields_to_what_presses_it = yield > 0;
    CHECK(a_pair_yields_to_what_presses_it);
    // |G_ij| is at most the mean of G_ii and G_jj.
    const bool no_coupling_beats_the_yields = std::abs(mine.coupling) < 0.3;
    CHECK(no_coupling_beats_the_yields);
  }
  const bool no_single_pair_is_worth_all = 0 < mine.share && mine.share < 1;
  CHECK(no_single_pair_is_worth_all);
  const bool a_bound_from_below_misses_something = mine.at_least < 0 && mine.missing > 0;
  CHECK(a_bound_from_below_misses_something);
}

// What a trade is worth follows from the overlap and the yield, (24).
TEST_CASE("ex2.3 the yields make the worth of the best pair", "[ex2.3]") {
  const Answers mine = answers();
  const ch02::Block block = ch02::pressed_block();
  const signorini::ContactProblem& problem = block.problem;
  REQUIRE((0 <= mine.best_pair && mine.best_pair < 3));
  const double overlap = -problem.free_gap(mine.best_pair);
  const double worth =
      0.5 * overlap * overlap / mine.yield[static_cast<std::size_t>(mine.best_pair)];
  const double best = ch02::trade(problem, ch02::shares(block)).energy;
  const bool share_fits_the_yield = std::abs(worth - mine.share * best) < 0.02 * best;
  CHECK(share_fits_the_yield);
}

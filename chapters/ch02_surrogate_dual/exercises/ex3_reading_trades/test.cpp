#include <cmath>

#include "../chapters/ch02_surrogate_dual/three_candidates.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using ex2_3::Answers;
using ex2_3::answers;

TEST_CASE("ex2.3 the answers fit each other", "[ex2.3]") {
  const Answers mine = answers();
  for (const double yield : mine.yield) {
    CHECK(yield > 0);  // a pair yields to what presses it
    // |G_ij| is at most the mean of G_ii and G_jj.
    CAPTURE(mine.coupling);
    const bool no_coupling_beats_the_yields = std::abs(mine.coupling) < 0.3;
    CHECK(no_coupling_beats_the_yields);
  }
  CAPTURE(mine.share);
  const bool no_single_pair_is_worth_all = 0 < mine.share && mine.share < 1;
  CHECK(no_single_pair_is_worth_all);
  CAPTURE(mine.at_least, mine.missing);
  const bool a_bound_from_below_misses_something = mine.at_least < 0 && mine.missing > 0;
  CHECK(a_bound_from_below_misses_something);
}

// What a trade is worth follows from the overlap and the yield, (24).
TEST_CASE("ex2.3 the yields make the worth of the best pair", "[ex2.3]") {
  const Answers mine = answers();
  const ch02::Block block = ch02::pressed_block();
  const signorini::ContactProblem& problem = block.problem;
  REQUIRE(0 <= mine.best_pair);
  REQUIRE(mine.best_pair < 3);
  const double overlap = -problem.free_gap(mine.best_pair);
  const double worth =
      0.5 * overlap * overlap / mine.yield[static_cast<std::size_t>(mine.best_pair)];
  const double best = ch02::trade(problem, ch02::shares(block)).energy;
  CAPTURE(mine.share);
  const bool share_fits_the_yield = std::abs(worth - mine.share * best) < 0.02 * best;
  CHECK(share_fits_the_yield);
}

// Without contact the energy is -13.462 N mm; contact adds to it, and what is left stays below zero.
TEST_CASE("ex2.3 the energies lie in their order", "[ex2.3]") {
  const Answers mine = answers();
  CHECK(-13.462 < mine.at_least);
  CHECK(mine.missing > 0);
  CHECK(mine.at_least + mine.missing < 0);
}

TEST_CASE("ex2.3 yields and couplings make up the whole compliance", "[ex2.3]") {
  const Answers mine = answers();
  const double all = ch02::pressed_block().problem.compliance.sum();
  const double yours = mine.yield[0] + mine.yield[1] + mine.yield[2] + 6 * mine.coupling;
  CHECK(yours == Approx(all).epsilon(0.1));
}

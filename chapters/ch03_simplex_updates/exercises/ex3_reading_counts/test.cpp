#include "../chapters/ch03_simplex_updates/three_problems.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"
#include "papers/weight_iteration.hpp"

using ex3_3::Answers;
using ex3_3::answers;
using signorini::WeightRule;

// Whether what is missing after k iterations is between a third of `goal` and three times as much.
static bool about(WeightRule rule, int k, double goal) {
  const signorini::ContactProblem punch = ch03::three_problems().front().problem;
  const double best =
      -0.5 * surrogate_dual(punch, WeightRule::FullyCorrective).force.dot(punch.free_gap);
  signorini::WeightIteration run(punch, rule);
  for (int i = 0; i < k && i < 20000; ++i)
    if (!run.step()) break;
  const double missing = 1 - run.value() / best;
  return goal / 3 < missing && missing < 3 * goal;
}

TEST_CASE("ex3.3 the answers fit each other", "[ex3.3]") {
  const Answers mine = answers();
  CAPTURE(mine.harmonic_5);
  const bool between_two_columns = 665 < mine.harmonic_5 && mine.harmonic_5 < 6438;
  CHECK(between_two_columns);
  CAPTURE(mine.away_10, mine.pairwise_10);
  const bool more_digits_take_more = mine.away_10 > 1018 && mine.pairwise_10 > 535;
  CHECK(more_digits_take_more);
  CAPTURE(mine.pairwise_10, mine.away_10);
  const bool pairwise_is_quicker = mine.pairwise_10 < mine.away_10;
  CHECK(pairwise_is_quicker);
  CAPTURE(mine.harmonic_power);
  const bool a_power_that_falls = 0 < mine.harmonic_power && mine.harmonic_power < 10;
  CHECK(a_power_that_falls);
  CAPTURE(mine.reaching_6);
  const bool some_rules_do_and_some_do_not = 0 < mine.reaching_6 && mine.reaching_6 < 6;
  CHECK(some_rules_do_and_some_do_not);
}

// 1018 iterations of away steps leave 1e-8, see the table.
TEST_CASE("ex3.3 a digit costs what the forecast takes for it", "[ex3.3]") {
  const Answers mine = answers();
  CHECK(mine.away_10 == Approx(1018 + 2 * mine.away_digit).epsilon(0.1));
  CHECK(mine.corrective_12 > 0);
}

TEST_CASE("ex3.3 the forecasts come true", "[ex3.3]") {
  const Answers mine = answers();
  CAPTURE(mine.harmonic_5);
  const bool harmonic = about(WeightRule::Harmonic, mine.harmonic_5, 1e-5);
  CHECK(harmonic);
  CAPTURE(mine.away_10);
  const bool away = about(WeightRule::AwaySteps, mine.away_10, 1e-10);
  CHECK(away);
  CAPTURE(mine.pairwise_10);
  const bool pairwise = about(WeightRule::Pairwise, mine.pairwise_10, 1e-10);
  CHECK(pairwise);
}

#include <cmath>

#include "../chapters/ch03_simplex_updates/three_problems.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"
#include "papers/weight_iteration.hpp"

using ex3_3::Answers;
using ex3_3::answers;
using signorini::WeightRule;

// Iterations until s* - s <= goal s*, at most 20 000.
static int count(WeightRule rule, double goal) {
  const signorini::ContactProblem punch = ch03::three_problems().front().problem;
  const double best =
      -0.5 * surrogate_dual(punch, WeightRule::FullyCorrective).force.dot(punch.free_gap);
  signorini::WeightIteration run(punch, rule);
  int k = 0;
  while (best - run.value() > goal * best && k < 20000 && run.step()) ++k;
  return best - run.value() <= goal * best ? k : 20001;
}

TEST_CASE("ex3.3 held out: a power of the iterations", "[ex3.3]") {
  const Answers mine = answers();
  const double ratio =
      static_cast<double>(count(WeightRule::Harmonic, 1e-6)) / count(WeightRule::Harmonic, 1e-4);
  CHECK(std::abs(mine.harmonic_power - std::log(100) / std::log(ratio)) < 0.1);
  CHECK(mine.harmonic_5 == Approx(count(WeightRule::Harmonic, 1e-5)).epsilon(0.1));
}

TEST_CASE("ex3.3 held out: the same for each digit, or nothing", "[ex3.3]") {
  const Answers mine = answers();
  CHECK(mine.away_10 == Approx(count(WeightRule::AwaySteps, 1e-10)).epsilon(0.1));
  CHECK(mine.pairwise_10 == Approx(count(WeightRule::Pairwise, 1e-10)).epsilon(0.1));
  const int digits = count(WeightRule::AwaySteps, 1e-8) - count(WeightRule::AwaySteps, 1e-6);
  CHECK(mine.away_digit == Approx(0.5 * digits).epsilon(0.1));
  CHECK(mine.corrective_12 == count(WeightRule::FullyCorrective, 1e-12));
}

TEST_CASE("ex3.3 held out: who arrives", "[ex3.3]") {
  int arrive = 0;
  for (const ch03::Rule& rule : ch03::rules) arrive += count(rule.rule, 1e-6) <= 20000 ? 1 : 0;
  CHECK(answers().reaching_6 == arrive);
}

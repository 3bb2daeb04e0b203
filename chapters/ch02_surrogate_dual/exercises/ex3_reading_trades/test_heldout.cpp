#include <cmath>

#include "../chapters/ch02_surrogate_dual/three_candidates.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using Eigen::Index;
using Eigen::Vector3d;
using ex2_3::Answers;
using ex2_3::answers;

TEST_CASE("ex2.3 held out: the answers are those of the scene", "[ex2.3]") {
  const Answers mine = answers();
  const ch02::Block block = ch02::pressed_block();
  const signorini::ContactProblem& problem = block.problem;
  const Eigen::MatrixXd& G = problem.compliance;
  Index best_pair = 0;
  double best_single = 0;
  for (Index i = 0; i < 3; ++i) {
    CAPTURE(i);
    CHECK(mine.yield[static_cast<std::size_t>(i)] == Approx(G(i, i)).epsilon(0.01));
    const double worth = ch02::trade(problem, Vector3d::Unit(i)).energy;
    if (worth <= best_single) continue;
    best_single = worth;
    best_pair = i;
  }
  CHECK(std::abs(mine.coupling - (G.sum() - G.trace()) / 6) < 0.001);
  CHECK(mine.best_pair == best_pair);
  const double best = ch02::trade(problem, ch02::shares(block)).energy;
  CHECK(std::abs(mine.share - best_single / best) < 0.005);
  const double equal = ch02::trade(problem, Vector3d::Constant(1.0 / 3)).energy;
  CHECK(std::abs(mine.missing - (best - equal)) < 0.01);
  const Eigen::VectorXd& u0 = block.free_displacement;
  const double free_energy = -0.5 * block.programme.load.dot(u0);
  CHECK(std::abs(mine.at_least - (free_energy + equal)) < 0.01);
}

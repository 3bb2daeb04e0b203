#include "catch_compat.hpp"
#include "exercise.hpp"
#include "papers/examples.hpp"
#include "papers/surrogate_dual.hpp"
#include "signorini/core/random.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "support/equal_within.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST_CASE("ex3.2 held out: the iteration finds the forces of random problems", "[ex3.2]") {
  const unsigned seed = GENERATE(range(0U, 40U));
  CAPTURE(seed);
  signorini::Random random(seed);
  const Index n = random.whole(2, 6);
  MatrixXd B(n, n);
  for (double& entry : B.reshaped()) entry = random.uniform(-1, 1);
  signorini::ContactProblem problem{B * B.transpose() + MatrixXd::Identity(n, n), VectorXd(n)};
  for (double& gap : problem.free_gap) gap = random.uniform(-1, 0.2);
  VectorXd weights = signorini::start_weights(problem);
  if (weights.sum() == 0) return;  // nothing overlaps
  double s = signorini::surrogate_dual_value(problem, weights);
  for (int k = 0; k < 2000; ++k) {
    weights = ex3_2::away_step(problem.compliance, problem.free_gap, weights);
    REQUIRE(weights.size() == n);
    REQUIRE(weights.minCoeff() >= 0);
    REQUIRE(weights.sum() == Approx(1).epsilon(1e-12));
    const double next = signorini::surrogate_dual_value(problem, weights);
    REQUIRE(next >= s * (1 - 1e-13));  // never downhill
    s = next;
  }
  const signorini::ContactState exact = signorini::enumerate(problem);
  CHECK(equal_within(weights, exact.force / exact.force.sum(), 1e-6));
  for (Index i = 0; i < n; ++i)
    if (exact.gap(i) > 0.05) CHECK(weights(i) == 0);  // open pairs are dropped, not just small
}

// The plain line search has not even four digits after as many steps.
TEST_CASE("ex3.2 held out: a punch on a half-plane to eight digits", "[ex3.2]") {
  const signorini::ContactProblem problem = signorini::half_plane_indentation(60).problem;
  const signorini::ContactState exact =
      signorini::surrogate_dual(problem, signorini::WeightRule::FullyCorrective);
  const double best = -0.5 * exact.force.dot(problem.free_gap);
  VectorXd weights = signorini::start_weights(problem);
  for (int k = 0; k < 2000; ++k)
    weights = ex3_2::away_step(problem.compliance, problem.free_gap, weights);
  CHECK(signorini::surrogate_dual_value(problem, weights) > best * (1 - 1e-8));
}

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "papers/surrogate_dual.hpp"
#include "signorini/core/random.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

struct Case {
  signorini::ContactProblem problem;
  VectorXd weights;
};

Case random_case(unsigned seed, double mean_gap) {
  signorini::Random random(seed);
  const Index n = random.whole(1, 7);
  MatrixXd B(n, n);
  for (double& entry : B.reshaped()) entry = random.uniform(-1, 1);
  Case made{{B * B.transpose() + 0.1 * MatrixXd::Identity(n, n), VectorXd(n)}, VectorXd(n)};
  for (double& gap : made.problem.free_gap) gap = mean_gap + random.uniform(-1, 1);
  for (double& weight : made.weights) weight = random.uniform(0.1, 1);
  return made;
}

VectorXd slope_of(const Case& made) {
  return ex2_1::gradient(made.problem.compliance, made.problem.free_gap, made.weights);
}

}  // namespace

TEST_CASE("ex2.1 held out: the slope agrees with central differences of s", "[ex2.1]") {
  const unsigned seed = GENERATE(range(0U, 50U));
  CAPTURE(seed);
  const Case made = random_case(seed, -2);
  const VectorXd slope = slope_of(made);
  REQUIRE(slope.size() == made.weights.size());
  const double s = signorini::surrogate_dual_value(made.problem, made.weights);
  for (Index i = 0; i < slope.size(); ++i) {
    const VectorXd h = 1e-5 * VectorXd::Unit(slope.size(), i);
    const double rise = signorini::surrogate_dual_value(made.problem, made.weights + h) -
                        signorini::surrogate_dual_value(made.problem, made.weights - h);
    CHECK(rise / 2e-5 == Approx(slope(i)).margin(1e-5 * s));
  }
}

TEST_CASE("ex2.1 held out: no slope along the weights, none where the gap is open", "[ex2.1]") {
  const unsigned seed = GENERATE(range(0U, 50U));
  CAPTURE(seed);
  const Case overlap = random_case(seed, -2);
  REQUIRE(slope_of(overlap).size() == overlap.weights.size());
  const double s = signorini::surrogate_dual_value(overlap.problem, overlap.weights);
  CHECK(std::abs(slope_of(overlap).dot(overlap.weights)) < 1e-12 * s);
  CHECK(slope_of(random_case(seed, 2)).cwiseAbs().sum() == 0);
}

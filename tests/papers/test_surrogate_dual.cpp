// The surrogate dual: one weighted gap for all, and six ways to change the weights.
#include <cmath>
#include <limits>

#include "addons/programme/dense_programme.hpp"
#include "catch_compat.hpp"
#include "papers/examples.hpp"
#include "papers/surrogate_dual.hpp"
#include "papers/weight_iteration.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "support/problems.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

const WeightRule all_rules[] = {WeightRule::LiteralVertex, WeightRule::Harmonic,
                                WeightRule::LineSearch,    WeightRule::AwaySteps,
                                WeightRule::Pairwise,      WeightRule::FullyCorrective};

VectorXd random_weights(Random& random, Index n) {
  VectorXd weights(n);
  for (double& weight : weights) weight = random.uniform(0, 1);
  return weights / weights.sum();
}

ContactProblem two_pairs(double coupling, const Vector2d& overlap) {
  Eigen::Matrix2d G;
  G << 1, coupling, coupling, 1;
  return {G, -overlap};
}

}  // namespace

TEST_CASE("the total force of one pair is the contact force",
          "[surrogate_dual][closed-form][XuanLi2002-19][XuanLi2002-23]") {
  for (const double gap : {-9.8, 0.0, 3.0}) {
    const ContactProblem problem{Eigen::MatrixXd::Constant(1, 1, 2), VectorXd::Constant(1, gap)};
    const double force = std::max(0.0, -gap / 2);
    CHECK(total_contact_force(problem, VectorXd::Ones(1)) == force);
    CHECK(surrogate_dual_value(problem, VectorXd::Ones(1)) == force * force);  // 1/2 eta^2 G
    CHECK(surrogate_dual_gradient(problem, VectorXd::Ones(1))(0) == 0);
  }
}

// If eta could be negative, the first vertex would have s = 2 and beat the second with s = 1/2.
TEST_CASE("an open weighted gap bears no force",
          "[surrogate_dual][closed-form][XuanLi2002-17][XuanLi2002-18]") {
  const ContactProblem problem = two_pairs(0, {-2, 1});
  CHECK(surrogate_dual_value(problem, Vector2d(1, 0)) == 0);
  CHECK(surrogate_dual_value(problem, Vector2d(0, 1)) == 0.5);
  CHECK(start_weights(problem) == VectorXd(Vector2d(0, 1)));  // the mean overlap is negative
  CHECK(start_weights(two_pairs(0, {-1, 2})) == VectorXd(Vector2d(0.5, 0.5)));
  CHECK(start_weights(two_pairs(0, {-1, 0})).norm() == 0);
}

TEST_CASE("weights in proportion to the forces give the least energy",
          "[surrogate_dual][XuanLi2002-15][XuanLi2002-16]") {
  Random random(3);
  for (int sample = 0; sample < 20; ++sample) {
    const ContactProblem problem = random_problem(random, 7);
    const ContactState state = enumerate(problem);
    const double best = -0.5 * state.force.dot(problem.free_gap);
    CHECK(surrogate_dual_value(problem, state.force) == Approx(best).epsilon(1e-11));
    for (int k = 0; k < 50; ++k)
      CHECK(surrogate_dual_value(problem, random_weights(random, 7)) <= best * (1 + 1e-12));
  }
}

TEST_CASE("s is the least Lagrangian above the energy without contact",
          "[surrogate_dual][XuanLi2002-14][XuanLi2002-16][XuanLi2002-24]") {
  const DenseProgramme dense = rosen_suzuki(5, 7, 2).programme;
  const DenseCondensed condensed = condense(dense);
  const QuadraticProgramme programme = sparse(dense);
  const ContactProblem problem = condensed.problem;
  const double free_energy = lagrangian(programme, condensed.free_displacement, VectorXd::Zero(7));
  CHECK(free_energy == Approx(-0.5 * dense.load.dot(condensed.free_displacement)).epsilon(1e-12));
  Random random(4);
  for (int sample = 0; sample < 50; ++sample) {
    const VectorXd weights = random_weights(random, 7);
    const VectorXd force = total_contact_force(problem, weights) * weights;
    const VectorXd u = condensed.factor.solve(dense.load - dense.A.transpose() * force);
    const double saddle = lagrangian(programme, u, force);
    CHECK(surrogate_dual_value(problem, weights) + free_energy == Approx(saddle).epsilon(1e-11));
    CHECK(lagrangian(programme, u + 1e-2 * VectorXd::Ones(5), force) > saddle);
  }
}

TEST_CASE("the gradient agrees with central differences",
          "[surrogate_dual][derivative][XuanLi2002-25]") {
  Random random(5);
  for (int sample = 0; sample < 20; ++sample) {
    ContactProblem problem = random_problem(random, 6);
    problem.free_gap.array() -= 1.5;  // every pair overlaps: eta > 0 for all weights
    const VectorXd weights = random_weights(random, 6);
    const VectorXd gradient = surrogate_dual_gradient(problem, weights);
    const double size = surrogate_dual_value(problem, weights);
    CHECK(std::abs(gradient.dot(weights)) < 1e-13 * size);  // of degree 0; eta gap.xi = 0
    const double h = 1e-5;  // h^2 and 1e-16 / h are both about 1e-10
    for (Index i = 0; i < 6; ++i) {
      const double rise = surrogate_dual_value(problem, weights + h * VectorXd::Unit(6, i)) -
                          surrogate_dual_value(problem, weights - h * VectorXd::Unit(6, i));
      CHECK(rise / (2 * h) == Approx(gradient(i)).margin(1e-6 * size).epsilon(1e-6));
    }
  }
}

TEST_CASE("the step in closed form beats golden section", "[surrogate_dual]") {
  Random random(6);
  int inside = 0;
  for (int sample = 0; sample < 300; ++sample) {
    const ContactProblem problem = random_problem(random, 4);
    const VectorXd from = random_weights(random, 4);
    const VectorXd along = VectorXd(VectorXd::Unit(4, random.whole(0, 3))) - from;
    const VectorXd product = problem.compliance * along;
    const WeightLine line{-problem.free_gap.dot(from), -problem.free_gap.dot(along),
                          from.dot(problem.compliance * from), from.dot(product),
                          along.dot(product)};
    if (line.overlap <= 0) continue;
    const double step = best_step(line, 1);
    REQUIRE((step >= 0 && step <= 1));
    inside += step > 0 && step < 1 ? 1 : 0;
    const auto s = [&](double t) { return surrogate_dual_value(problem, from + t * along); };
    double low = 0;
    double high = 1;
    for (int k = 0; k < 80; ++k) {  // s rises, then falls: pseudo-concave
      const double third = (high - low) * 0.381966011250105;
      (s(low + third) < s(high - third) ? low : high) =
          s(low + third) < s(high - third) ? low + third : high - third;
    }
    CHECK(s(step) >= s(0.5 * (low + high)) * (1 - 1e-13));
    CHECK(step == Approx(0.5 * (low + high)).margin(1e-6));  // flat: root of the rounding of s
  }
  CHECK(inside > 40);
}

TEST_CASE("two pairs: the literal rule hops, the line search arrives at once",
          "[surrogate_dual][closed-form][XuanLi2002-28]") {
  const ContactProblem problem = two_pairs(0.5, {4, 3.5});  // forces (3, 2), s = 9.5
  WeightIteration literal(problem, WeightRule::LiteralVertex);
  std::vector<double> values;
  while (literal.step()) values.push_back(literal.value());
  CHECK(literal.end() == WeightEnd::Repeats);
  CHECK(values == std::vector<double>{8, 6.125});  // vertex 1, vertex 2
  WeightIteration search(problem, WeightRule::LineSearch);
  REQUIRE(search.step());
  CHECK(search.value() == Approx(9.5).epsilon(1e-14));
  CHECK(search.weights()(0) == Approx(0.6).epsilon(1e-14));
  CHECK(surrogate_dual(problem, WeightRule::LiteralVertex).report.status ==
        SolveStatus::IterationLimit);
}

TEST_CASE("all rules but the first two never lower s, and none leaves the simplex",
          "[surrogate_dual]") {
  const ContactProblem problem = half_plane_indentation(40).problem;
  for (const WeightRule rule : all_rules) {
    WeightIteration run(problem, rule);
    double before = run.value();
    for (int k = 0; k < 500 && run.step(); ++k) {
      CHECK(run.weights().minCoeff() >= 0);
      CHECK(run.weights().sum() == Approx(1).epsilon(1e-13));
      CHECK(run.value() == Approx(surrogate_dual_value(problem, run.weights())).epsilon(1e-11));
      if (rule != WeightRule::LiteralVertex && rule != WeightRule::Harmonic)
        CHECK(run.value() >= before * (1 - 1e-13));
      before = run.value();
    }
    if (rule == WeightRule::FullyCorrective) CHECK(run.end() == WeightEnd::Optimal);
  }
}

TEST_CASE("the bound on the gap that is left holds near the end", "[surrogate_dual]") {
  const ContactProblem problem = half_plane_indentation(40).problem;
  const ContactState exact = surrogate_dual(problem, WeightRule::FullyCorrective);
  REQUIRE(exact.report.status == SolveStatus::Solved);
  const double best = -0.5 * exact.force.dot(problem.free_gap);
  WeightIteration run(problem, WeightRule::Pairwise);
  for (int k = 0; k < 300 && run.step(); ++k) {
    const double bound = run.relative_gap() * exact.force.sum() / run.total_force();
    CHECK(best - run.value() <= bound * run.value() + 1e-15 * best);
  }
}

TEST_CASE("the start is the mean of all pairs if they overlap in the mean, else of those that do",
          "[surrogate_dual][XuanLi2002-29]") {
  CHECK(start_weights(two_pairs(0.3, {2, 1})) == Vector2d(0.5, 0.5));
  CHECK(start_weights(two_pairs(0.3, {2, -1})) == Vector2d(0.5, 0.5));
  CHECK(start_weights(two_pairs(0.3, {1, -2})) == Vector2d(1, 0));
  CHECK(start_weights(two_pairs(0.3, {-1, -2})) == Vector2d(0, 0));
}

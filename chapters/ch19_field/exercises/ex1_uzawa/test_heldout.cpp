#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/random.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "support/equal_within.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

signorini::ContactProblem random_problem(signorini::Random& random, Index n) {
  MatrixXd root(n, n);
  for (Index i = 0; i < n * n; ++i) root(i) = random.uniform(-1, 1);
  VectorXd d(n);
  for (Index i = 0; i < n; ++i) d(i) = random.uniform(-1, 0.5);
  return {root * root.transpose() + MatrixXd::Identity(n, n), d};
}

}  // namespace

TEST_CASE("ex19.1 held out: the solution of random problems", "[ex19.1]") {
  signorini::Random random(19);
  for (int sample = 0; sample < 30; ++sample) {
    const signorini::ContactProblem problem = random_problem(random, 6);
    const ex19_1::Ending end = ex19_1::uzawa(problem.compliance, problem.free_gap, 1e-12, 100000);
    CAPTURE(sample);
    CHECK(end.ended);
    const VectorXd right = signorini::enumerate(problem).force;
    CHECK(equal_within(end.force, right, 1e-8 * (1 + right.norm())));
    CHECK(end.force.minCoeff() >= 0);
  }
}

TEST_CASE("ex19.1 held out: the passes do not depend on units of force and length", "[ex19.1]") {
  signorini::Random random(20);
  const signorini::ContactProblem problem = random_problem(random, 5);
  const ex19_1::Ending one = ex19_1::uzawa(problem.compliance, problem.free_gap, 1e-8, 100000);
  for (const double length : {0x1p-20, 0x1p20})
    for (const double force : {0x1p-16, 0x1p16}) {
      const ex19_1::Ending other = ex19_1::uzawa(length / force * problem.compliance,
                                                 length * problem.free_gap, 1e-8, 100000);
      CAPTURE(length, force);
      CHECK(other.passes == one.passes);
      CHECK(equal_within(other.force / force, one.force, 1e-13 * one.force.norm()));
    }
}

TEST_CASE("ex19.1 held out: the accuracy is that of the text, pass by pass", "[ex19.1]") {
  const MatrixXd G = MatrixXd::Constant(1, 1, 2);  // the step is 1/2: right after one pass
  const ex19_1::Ending end = ex19_1::uzawa(G, VectorXd::Constant(1, -3), 1e-6, 10);
  CHECK(end.ended);
  CHECK(end.passes == 2);
  CHECK(end.force(0) == Approx(1.5).epsilon(1e-15));
  CHECK(!ex19_1::uzawa(G, VectorXd::Constant(1, -3), 1e-6, 1).ended);
}

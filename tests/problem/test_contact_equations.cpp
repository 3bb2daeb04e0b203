#include "catch_compat.hpp"
#include "signorini/problem/contact_equations.hpp"
#include "support/friction.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

/// The largest difference of J from central differences, over the largest entry of J.
double error_of_derivatives(const ScaledProblem& problem, const Formulation& form, Random& random) {
  ContactEquations equations(problem, form);
  VectorXd x(equations.size());
  for (Index k = 0; k < x.size(); ++k) x(k) = random.uniform(0.2, 1.5) * (k % 3 == 0 ? -1 : 1);
  equations.choose_closed(x);
  VectorXd here(x.size());
  MatrixXd J(x.size(), x.size());
  equations.evaluate(x, here);
  equations.differentiate(x, J);
  const double h = 1e-6;
  MatrixXd differences(x.size(), x.size());
  for (Index k = 0; k < x.size(); ++k) {
    VectorXd moved = x;
    VectorXd beyond(x.size());
    VectorXd before(x.size());
    moved(k) = x(k) + h;
    equations.evaluate(moved, beyond);
    moved(k) = x(k) - h;
    equations.evaluate(moved, before);
    differences.col(k) = (beyond - before) / (2 * h);
  }
  return (J - differences).cwiseAbs().maxCoeff() / J.cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("derivatives of the contact equations are those of central differences",
          "[contact_equations]") {
  Random random(11);
  for (int sample = 0; sample < 50; ++sample) {
    const Index pairs = random.whole(1, 5);
    const ScaledProblem held = equilibrate(random_friction(random, pairs, 0.8, 0.3));
    const ScaledProblem floating = equilibrate(random_floating(random, pairs, 0.8));
    CAPTURE(sample, pairs);
    CHECK(error_of_derivatives(held, nested_friction, random) <= 1e-7);
    CHECK(error_of_derivatives(floating, nested_friction, random) <= 1e-7);
  }
}

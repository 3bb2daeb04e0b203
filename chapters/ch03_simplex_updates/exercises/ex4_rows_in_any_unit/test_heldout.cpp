#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "papers/examples.hpp"
#include "papers/surrogate_dual.hpp"
#include "signorini/core/random.hpp"
#include "support/equal_within.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using ex3_4::update;
using signorini::ContactProblem;

namespace {

ContactProblem in_units(const ContactProblem& problem, const VectorXd& row) {
  return {row.asDiagonal() * problem.compliance * row.asDiagonal(),
          row.cwiseProduct(problem.free_gap)};
}

VectorXd shares(const VectorXd& force) { return force / force.sum(); }

}  // namespace

TEST_CASE("ex3.4 held out: the same way in any units, and always upwards", "[ex3.4]") {
  signorini::Random random(34);
  for (int sample = 0; sample < 50; ++sample) {
    const Index n = random.whole(2, 9);
    MatrixXd B(n, n);
    VectorXd d(n), row(n);
    for (double& entry : B.reshaped()) entry = random.uniform(-1, 1);
    for (double& entry : d) entry = random.uniform(-1, -0.1);
    for (double& entry : row) entry = std::ldexp(1, random.whole(-20, 20));
    const ContactProblem plain{B * B.transpose() + 0.1 * MatrixXd::Identity(n, n), d};
    const ContactProblem other = in_units(plain, row);
    VectorXd xi = VectorXd::Constant(n, 1.0 / static_cast<double>(n));
    VectorXd zeta = shares(xi.cwiseQuotient(row));
    CAPTURE(sample, n);
    for (int k = 0; k < 20; ++k) {
      const double before = surrogate_dual_value(plain, xi);
      xi = update(plain, xi);
      zeta = update(other, zeta);
      REQUIRE(xi.minCoeff() >= 0);
      REQUIRE(surrogate_dual_value(plain, xi) >= before * (1 - 1e-14));
      CHECK(xi.sum() == Approx(1).epsilon(1e-13));
      CHECK(equal_within(shares(zeta.cwiseProduct(row)), xi, 1e-10));
      CHECK(surrogate_dual_value(other, zeta) ==
            Approx(surrogate_dual_value(plain, xi)).epsilon(1e-12));
    }
  }
}

// In units as they come, the row in the smallest unit would be the only one that is ever looked at.
TEST_CASE("ex3.4 held out: a punch whose rows are in units from micrometres to metres", "[ex3.4]") {
  const signorini::Indentation punch = signorini::half_plane_indentation(30);
  VectorXd row(30);
  for (Index i = 0; i < 30; ++i) row(i) = std::pow(10, i % 7 - 3);
  const ContactProblem problem = in_units(punch.problem, row);
  VectorXd xi = shares(VectorXd::Ones(30).cwiseQuotient(row));
  for (int k = 0; k < 300; ++k) xi = update(problem, xi);
  const double best =
      -0.5 *
      surrogate_dual(problem, signorini::WeightRule::FullyCorrective).force.dot(problem.free_gap);
  CHECK(surrogate_dual_value(problem, xi) > 0.99 * best);
}

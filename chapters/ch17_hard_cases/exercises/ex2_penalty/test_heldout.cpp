#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"
#include "support/equal_within.hpp"

using Eigen::VectorXd;
using ex17_2::forces_of;
using ex17_2::stiffness_for;
using signorini::ContactProblem;

// A string over a wavy floor, in exact fractions of its compliance.
static ContactProblem string(Eigen::Index n) {
  Eigen::MatrixXd G(n, n);
  VectorXd d(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    d(i) = (i % 3 == 0 ? -1.0 : 0.5) - 0.1 * static_cast<double>(i);
    for (Eigen::Index j = 0; j < n; ++j)
      G(i, j) = static_cast<double>((std::min(i, j) + 1) * (n - std::max(i, j)));
  }
  return {G, d};
}

TEST_CASE("ex17.2 held out: springs keep their law, and stiff ones the problem", "[ex17.2]") {
  for (const Eigen::Index n : {2, 5, 9})
    for (const double k : {1e-4, 1e-2, 1.0, 1e10}) {
      CAPTURE(n, k);
      const ContactProblem problem = string(n);
      const VectorXd force = forces_of(problem, k);
      const VectorXd gap = problem.free_gap + problem.compliance * force;
      const double size = problem.free_gap.cwiseAbs().maxCoeff();
      for (Eigen::Index i = 0; i < n; ++i) {
        CHECK(force(i) >= 0);
        if (force(i) > 0) CHECK(gap(i) == Approx(-force(i) / k).margin(1e-12 * size));
        if (force(i) == 0) CHECK(gap(i) >= 0);
      }
      if (k == 1e10)
        CHECK(equal_within(force, signorini::primal_dual_active_set(problem, {}).force,
                           1e-7 * force.norm()));
    }
}

TEST_CASE("ex17.2 held out: no unit changes what the springs do", "[ex17.2]") {
  const ContactProblem problem = string(5);
  const double k = stiffness_for(problem, 1e-3);
  const double deepest = -problem.free_gap.minCoeff();
  CHECK(forces_of(problem, k).maxCoeff() / k == Approx(1e-3 * deepest).epsilon(1e-7));
  for (const double length : {1e-9, 1e9})
    for (const double force : {1e-9, 1e9}) {
      CAPTURE(length, force);
      const ContactProblem other{problem.compliance * length / force, problem.free_gap * length};
      CHECK(stiffness_for(other, 1e-3) == Approx(k * force / length).epsilon(1e-8));
    }
}

// Whole groups of pairs that come and go may go round for ever: that is said.
TEST_CASE("ex17.2 held out: a cycle is no answer", "[ex17.2]") {
  Eigen::Matrix3d G;
  G << 4, -6, -4, -6, 10, 8, -4, 8, 9;
  CHECK_THROWS_AS(forces_of({G, Eigen::Vector3d(3, -4, -1)}, 1e9), signorini::NotSolved);
}

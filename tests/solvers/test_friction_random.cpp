#include <cmath>

#include "catch_compat.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/closing/proofs.hpp"
#include "signorini/solvers/solvers.hpp"
#include "support/friction.hpp"

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

/// Whether forces are among the solutions that trying all motions gives.
bool among(const VectorXd& force, const std::vector<VectorXd>& solutions) {
  for (const VectorXd& other : solutions)
    if ((force - other).norm() <= 1e-10 * other.norm()) return true;
  return false;
}

/// A bound on the iterations of a method on up to 8 pairs with moderate friction.
Index most_iterations(const Solver& solver) {
  return std::string(solver.name) == "lemke" ? 60 : 12;
}

}  // namespace

TEST_CASE("moderate friction: one solution, found by all methods that promise it",
          "[friction][conformance]") {
  Random random(21);
  for (int trial = 0; trial < 200; ++trial) {
    const ContactProblem problem = random_friction(random, 1 + trial % 8, 0.5);
    const std::vector<VectorXd> solutions =
        problem.free_gap.size() <= 4 ? all_solutions(problem) : std::vector<VectorXd>();
    if (problem.free_gap.size() <= 4) CHECK(solutions.size() == 1);
    for (const Solver& solver : friction_solvers()) {
      const ContactState state = solver.solve(problem, {});
      CAPTURE(trial, solver.name, state.reason);
      if (!may_fail(solver, Trait::Friction)) REQUIRE(state.report.status == Status::Solved);
      if (state.report.status != Status::Solved) continue;
      CHECK(certify(problem, state).holds());
      if (!solutions.empty()) CHECK(among(forces(state), solutions));
      if (!may_fail(solver, Trait::Friction)) CHECK(state.report.iterations <= most_iterations(solver));
    }
  }
}

TEST_CASE("strong friction: several solutions, of which one is found; never called the only one",
          "[friction][hard]") {
  Random random(22);
  int several = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const double mu = trial % 2 == 0 ? 3 : 1e4;
    const ContactProblem problem = random_friction(random, 1 + trial % 4, mu);
    const std::vector<VectorXd> solutions = all_solutions(problem);
    REQUIRE_FALSE(solutions.empty());
    several += solutions.size() > 1 ? 1 : 0;
    for (const Solver& solver : friction_solvers()) {
      const ContactState state = solver.solve(problem, {});
      CAPTURE(trial, solver.name, state.reason);
      if (!may_fail(solver, Trait::Friction)) REQUIRE(state.report.status == Status::Solved);
      if (state.report.status != Status::Solved) continue;
      CHECK(among(forces(state), solutions));
      if (solutions.size() > 1) CHECK(state.uniqueness != Uniqueness::Proved);
    }
  }
  CHECK(several >= 10);
}

TEST_CASE("cohesion of closed pairs only: solved if and only if a solution exists",
          "[friction][hard]") {
  Random random(23);
  int none = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const ContactProblem problem = random_friction(random, 1 + trial % 4, 0.5, 0.3);
    const std::vector<VectorXd> solutions = all_solutions(problem);
    none += solutions.empty() ? 1 : 0;
    const ContactState state = friction_solvers().front().solve(problem, {});
    CAPTURE(trial, state.reason);
    CHECK((state.report.status == Status::Solved) == !solutions.empty());
    if (state.report.status == Status::Solved) CHECK(among(forces(state), solutions));
    if (state.report.status != Status::Solved) CHECK_FALSE(state.reason.empty());
    CHECK(state.uniqueness == Uniqueness::Unknown);
  }
  CHECK(none >= 1);
}

TEST_CASE("a body that is free to move: solved if and only if a solution exists",
          "[friction][floating]") {
  // That forces could balance the load is not enough where the coefficient differs from pair to pair.
  Random random(24);
  int none = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const ContactProblem problem = random_floating(random, 1 + trial % 4, 0.5);
    const std::vector<VectorXd> solutions = all_solutions(problem);
    none += solutions.empty() ? 1 : 0;
    for (const Solver& solver : friction_solvers()) {
      const ContactState state = solver.solve(problem, {});
      CAPTURE(trial, solver.name, state.reason);
      CHECK(state.report.status != Status::Infeasible);
      if (!may_fail(solver, Trait::Friction)) CHECK((state.report.status == Status::Solved) == !solutions.empty());
      if (state.report.status == Status::Solved) CHECK(among(forces(state), solutions));
    }
  }
  CHECK(none >= 1);
  CHECK(none <= 20);
}

TEST_CASE("a pair that only its cohesion would pull open has no solution",
          "[friction][closed-form]") {
  // It overlaps by 0.1 and tends to slide; at most 1 of friction force opens it by up to 0.5. Open, it
  // overlaps; closed, it would need a tensile force.
  Matrix2d F;
  F << 1, -0.5, -0.5, 1;
  const ContactProblem problem = one_pair(F, -0.1, 3, 0, 1);
  CHECK(all_solutions(problem).empty());
  for (const Solver& solver : friction_solvers())
    CHECK(solver.solve(problem, {}).report.status != Status::Solved);
}

TEST_CASE("one node with several solutions: one is found, with the warning", "[friction][hard]") {
  // tests/data/generated/coulomb_one_node_nonunique.txt
  Matrix2d F;
  F << 1, 2, 2, 9;
  for (const Solver& solver : friction_solvers()) {
    const ContactState unique = solver.solve(one_pair(F, 0.1, 3, 0.3), {});
    const ContactState state = solver.solve(one_pair(F, 0.1, 3, 0.6), {});
    CAPTURE(solver.name);
    REQUIRE(state.report.status == Status::Solved);
    CHECK(certify(one_pair(F, 0.1, 3, 0.6), state).worst() <= 1e-15);
    if (std::string(solver.name) == "friction_split_literal") continue;
    CHECK(state.uniqueness == Uniqueness::Doubtful);
    CHECK(unique.uniqueness == Uniqueness::Proved);
  }
  const std::vector<VectorXd> solutions = all_solutions(one_pair(F, 0.1, 3, 0.6));
  CHECK(solutions.size() == 3);
  CHECK(among(Eigen::Vector2d(0, 0), solutions));
  CHECK(among(Eigen::Vector2d(1.02, -0.56), solutions));
  CHECK(among(Eigen::Vector2d(0.5, -0.3), solutions));
}

TEST_CASE("the warning starts where one node stops being unique", "[friction][closed-form]") {
  // Stiffness [1 0.6; 0.6 1]: several solutions exist from mu = 1 / 0.6 on; the proof ends at 1.6.
  Matrix2d F;
  F << 1 / 0.64, -0.6 / 0.64, -0.6 / 0.64, 1 / 0.64;
  const auto verdict = [&](double mu) {
    return friction_solvers().front().solve(one_pair(F, -1, 0.3, mu), {}).uniqueness;
  };
  CHECK(verdict(1.59) == Uniqueness::Proved);
  CHECK(verdict(1.61) == Uniqueness::Unknown);
  CHECK(verdict(1.66) == Uniqueness::Unknown);
  CHECK(verdict(1.67) == Uniqueness::Doubtful);
}

TEST_CASE("a solution on the turned branch warns of the others", "[friction][hard]") {
  Matrix2d F;
  F << 1, 2, 2, 9;
  const ContactProblem problem = one_pair(F, 0.1, 3, 0.6);
  const ScaledProblem scaled = equilibrate(problem);
  const auto reversed = [&](Motion motion) {
    const std::vector<Motion> motions = {motion};
    const Closure end = close(scaled, motions);
    CHECK(solves(scaled, motions, end));
    return end.reversed;
  };
  CHECK_FALSE(reversed(Motion::Open));
  CHECK_FALSE(reversed(Motion::Stick));
  CHECK(reversed(Motion::Forward));  // 1 - 2 mu < 0
}

#include <algorithm>

#include "addons/certified/solve_with_proofs.hpp"
#include "catch_compat.hpp"
#include "papers/examples.hpp"
#include "papers/solver_table.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using namespace signorini;

namespace {

/// The parabolic punch on the half-plane, pressed by a force: how far it comes down is unknown. It hangs
/// `lift` above the half-plane, or is put into it.
ContactProblem punch(Index n, double lift, double load = 1, double length = 1, double force = 1) {
  const Indentation example = half_plane_indentation(n);
  return {example.problem.compliance * (length / force),
          VectorXd(length * (0.5 * example.position.array().square() + lift)),
          {},
          {},
          MatrixXd::Ones(n, 1),
          VectorXd::Constant(1, load * force * example.total_force)};
}

/// The members that take few steps without springs.
std::vector<Solver> direct() {
  return {find_solver("primal_dual_active_set"), find_solver("fischer_burmeister")};
}

/// Solves, certified, without springs and in at most so many iterations.
ContactState direct_solution(const ContactProblem& problem, const Solver& solver, Index most) {
  const ContactState state = solve_with_proofs(problem, solver);
  REQUIRE(state.report.status == SolveStatus::Solved);
  CHECK(state.report.iterations <= most);
  CHECK(certify(problem, state).worst() <= 1e-14);
  return state;
}

double difference(const VectorXd& one, const VectorXd& other) {
  return (one - other).norm() / other.norm();
}

}  // namespace

TEST_CASE("Hertz under a given force: at most 10 iterations, and the pressure of the continuum",
          "[floating-newton][closed-form][LinEtAl-28]") {
  for (const Solver& solver : direct())
    for (const Index n : {10, 30, 100, 400}) {
      CAPTURE(solver.name, n);
      const ContactState state = direct_solution(punch(n, 0), solver, 10);
      const Indentation exact = half_plane_indentation(n);
      const double h = 2.0 / static_cast<double>(n);  // forces are right to the order of h
      CHECK(difference(state.force, exact.force) <= 2 * h);
      CHECK(state.force.sum() == Approx(exact.total_force).epsilon(1e-14));
      for (const Index i : state.active()) CHECK(std::abs(exact.position(i)) <= exact.half_width + h);
    }
}

TEST_CASE("neither height nor overlap at the start cost an iteration", "[floating-newton]") {
  for (const Solver& solver : direct()) {
    const ContactState touching = direct_solution(punch(100, 0), solver, 10);
    for (const double lift : {0.1, 1.0, 10.0, 1e3, -1e-6, -1e-3, -0.1, -1.0, -10.0}) {
      CAPTURE(solver.name, lift);
      const ContactState state = direct_solution(punch(100, lift), solver, 10);
      CHECK(state.report.iterations == touching.report.iterations);
      // Gaps of the size of the lift are rounded, and the profile with them.
      CHECK(difference(state.force, touching.force) <= 1e-14 + 1e-13 * std::abs(lift));
      CHECK(state.amplitude(0) == Approx(touching.amplitude(0) - lift).epsilon(1e-13));
    }
  }
}

TEST_CASE("units change neither forces nor iterations", "[floating-newton]") {
  for (const Solver& solver : direct()) {
    const ContactState reference = direct_solution(punch(100, 0.1), solver, 10);
    for (const double length : {1e-6, 1e-3, 1.0, 1e3, 1e6})
      for (const double force : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
        CAPTURE(solver.name, length, force);
        const ContactState state = direct_solution(punch(100, 0.1, 1, length, force), solver, 10);
        CHECK(difference(state.force / force, reference.force) <= 7e-13);
        CHECK(state.report.iterations == reference.report.iterations);
      }
  }
}

TEST_CASE("the springs that ground a body are not noticed", "[floating-newton]") {
  for (const Solver& solver : direct()) {
    const ContactState reference = direct_solution(punch(100, 0), solver, 10);
    for (const double soft : {1e-6, 1.0, 1e3, 1e6}) {
      ContactProblem problem = punch(100, 0);
      problem.compliance.array() += soft;  // G + soft R R^T
      CAPTURE(solver.name, soft);
      const ContactState state = direct_solution(problem, solver, 10);
      CHECK(difference(state.force, reference.force) <= 1e-14 + 1e-16 * soft);
    }
  }
}

TEST_CASE("loads and gaps of any size, and none", "[floating-newton]") {
  for (const Solver& solver : direct()) {
    for (const double load : {1e-16, 1e-12, 1e-9, 1e-6, 1e-3, 10.0, 1e3})
      for (const double lift : {0.0, 0.1, 1e-16}) {
        CAPTURE(solver.name, load, lift);
        direct_solution(punch(100, lift, load), solver, 10);
      }
    ContactProblem flat = punch(100, 0, 0);  // conforming, without load
    flat.free_gap.setZero();
    CAPTURE(solver.name);
    CHECK(direct_solution(flat, solver, 2).force.isZero(0));
    flat.free_gap.setConstant(1e-16);
    flat.resultant(0) = 1e-16;
    CHECK(direct_solution(flat, solver, 2).force.sum() == Approx(1e-16));
    CHECK(solve_with_proofs(punch(100, 0.1, 0), solver).report.status == SolveStatus::Solved);
  }
}

TEST_CASE("only rigid motions, no compliance: the law of the lever",
          "[floating-newton][closed-form]") {
  ContactProblem bar{MatrixXd::Zero(2, 2), Vector2d(1, 2), {}, {}, MatrixXd(2, 2), Vector2d(6, 6)};
  bar.rigid << 1, 0, 1, 3;
  for (const Solver& solver : direct()) {
    CAPTURE(solver.name);
    const ContactState state = direct_solution(bar, solver, 2);
    CHECK((state.force - Vector2d(4, 2)).norm() <= 1e-14);
    CHECK((bar.rigid * state.amplitude + Vector2d(1, 2)).norm() <= 1e-14);
  }
}

TEST_CASE("where the direct way ends without a solution, springs come in", "[floating-newton]") {
  Solver solver = find_solver("primal_dual_active_set");
  solver.solve = [](const ContactProblem& problem, const SolverOptions& options) {
    if (problem.resultant.size() == 0) return primal_dual_active_set(problem, options);
    ContactState nothing;
    nothing.force = nothing.gap = VectorXd::Zero(problem.free_gap.size());
    nothing.report.iterations = 7;
    return nothing;
  };
  const ContactState state = solve_with_proofs(punch(30, 0.1), solver);
  REQUIRE(state.report.status == SolveStatus::Solved);
  CHECK(state.report.iterations > 7);
}

#include <algorithm>

#include "catch_compat.hpp"
#include "signorini/problem/examples.hpp"
#include "signorini/solvers/springs.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using namespace signorini;

namespace {

/// The parabolic punch on the half-plane, pressed by a force: how far it comes down is unknown. It hangs
/// `lift` above the half-plane, or is put into it.
FloatingProblem punch(Index n, double lift, double load = 1, double length = 1, double force = 1) {
  const Indentation example = half_plane_indentation(n);
  return {{example.problem.compliance * (length / force),
           VectorXd(length * (0.5 * example.position.array().square() + lift))},
          MatrixXd::Ones(n, 1),
          VectorXd::Constant(1, load * force * example.total_force)};
}

/// The members that solve floating problems without springs.
std::vector<Solver> direct() {
  std::vector<Solver> members;
  for (const Solver& solver : solvers())
    if (solver.solve_floating != nullptr) members.push_back(solver);
  REQUIRE(members.size() == 2);
  return members;
}

/// Solves, certified, without springs and in at most so many iterations.
FloatingState direct_solution(const FloatingProblem& problem, const Solver& solver, Index most) {
  const FloatingState state = solve(problem, solver);
  REQUIRE(state.contact.report.status == Status::Solved);
  CHECK(state.passes == 0);
  CHECK(state.contact.report.iterations <= most);
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
      const FloatingState state = direct_solution(punch(n, 0), solver, 10);
      const Indentation exact = half_plane_indentation(n);
      const double h = 2.0 / static_cast<double>(n);  // forces are right to the order of h
      CHECK(difference(state.contact.force, exact.force) <= 2 * h);
      CHECK(state.contact.force.sum() == Approx(exact.total_force).epsilon(1e-14));
      for (const Index i : state.contact.active)
        CHECK(std::abs(exact.position(i)) <= exact.half_width + h);
    }
}

TEST_CASE("neither height nor overlap at the start cost an iteration", "[floating-newton]") {
  for (const Solver& solver : direct()) {
    const FloatingState touching = direct_solution(punch(100, 0), solver, 10);
    for (const double lift : {0.1, 1.0, 10.0, 1e3, -1e-6, -1e-3, -0.1, -1.0, -10.0}) {
      CAPTURE(solver.name, lift);
      const FloatingState state = direct_solution(punch(100, lift), solver, 10);
      CHECK(state.contact.report.iterations == touching.contact.report.iterations);
      // Gaps of the size of the lift are rounded, and the profile with them.
      CHECK(difference(state.contact.force, touching.contact.force) <=
            1e-14 + 1e-13 * std::abs(lift));
      CHECK(state.amplitude(0) == Approx(touching.amplitude(0) - lift).epsilon(1e-13));
    }
  }
}

TEST_CASE("units change neither forces nor iterations", "[floating-newton]") {
  for (const Solver& solver : direct()) {
    const FloatingState reference = direct_solution(punch(100, 0.1), solver, 10);
    for (const double length : {1e-6, 1e-3, 1.0, 1e3, 1e6})
      for (const double force : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
        CAPTURE(solver.name, length, force);
        const FloatingState state = direct_solution(punch(100, 0.1, 1, length, force), solver, 10);
        CHECK(difference(state.contact.force / force, reference.contact.force) <= 7e-13);
        CHECK(state.contact.report.iterations == reference.contact.report.iterations);
      }
  }
}

TEST_CASE("the springs that ground a body are not noticed", "[floating-newton]") {
  for (const Solver& solver : direct()) {
    const FloatingState reference = direct_solution(punch(100, 0), solver, 10);
    for (const double soft : {1e-6, 1.0, 1e3, 1e6}) {
      FloatingProblem problem = punch(100, 0);
      problem.contact.compliance.array() += soft;  // G + soft R R^T
      CAPTURE(solver.name, soft);
      const FloatingState state = direct_solution(problem, solver, 10);
      CHECK(difference(state.contact.force, reference.contact.force) <= 1e-14 + 1e-16 * soft);
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
    FloatingProblem flat = punch(100, 0, 0);  // conforming, without load
    flat.contact.free_gap.setZero();
    CAPTURE(solver.name);
    CHECK(direct_solution(flat, solver, 2).contact.force.isZero(0));
    flat.contact.free_gap.setConstant(1e-16);
    flat.resultant(0) = 1e-16;
    CHECK(direct_solution(flat, solver, 2).contact.force.sum() == Approx(1e-16));
    CHECK(solve(punch(100, 0.1, 0), solver).contact.report.status == Status::Solved);
  }
}

TEST_CASE("only rigid motions, no compliance: the law of the lever",
          "[floating-newton][closed-form]") {
  FloatingProblem bar{{MatrixXd::Zero(2, 2), Vector2d(1, 2)}, MatrixXd(2, 2), Vector2d(6, 6)};
  bar.rigid << 1, 0, 1, 3;
  for (const Solver& solver : direct()) {
    CAPTURE(solver.name);
    const FloatingState state = direct_solution(bar, solver, 2);
    CHECK((state.contact.force - Vector2d(4, 2)).norm() <= 1e-14);
    CHECK((bar.rigid * state.amplitude + Vector2d(1, 2)).norm() <= 1e-14);
  }
}

TEST_CASE("where the direct way ends without a solution, springs come in", "[floating-newton]") {
  for (Solver solver : direct()) {
    solver.solve_floating = [](const FloatingProblem& problem, const SolverOptions&) {
      FloatingState nothing;
      nothing.contact.force = nothing.contact.gap = VectorXd::Zero(problem.contact.free_gap.size());
      nothing.contact.report.iterations = 7;
      return nothing;
    };
    const FloatingState state = solve(punch(30, 0.1), solver);
    CAPTURE(solver.name);
    REQUIRE(state.contact.report.status == Status::Solved);
    CHECK(state.passes > 0);
    CHECK(state.contact.report.iterations > 7);
  }
}

// What every member of the family of solvers promises besides the right answer, which classes.cpp asks
// for: the same bits again, no knowledge of units, and that bad input is refused.

#include <cmath>

#include "addons/certified/solve_with_proofs.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "support/chosen.hpp"
#include "support/problem_classes.hpp"
#include "support/problems.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// The first few small problems of each class.
std::vector<Instance> first_problems() {
  std::vector<Instance> first;
  for (const ProblemClass& group : problem_classes()) {
    int taken = 0;
    for (const Instance& instance : group.instances())
      if (instance.problem.free_gap.size() <= 25 && ++taken <= 3) first.push_back(instance);
  }
  return first;
}

/// Those of them that a solver accepts.
std::vector<Instance> sample_for(const Solver& solver) {
  static const std::vector<Instance> first = first_problems();
  std::vector<Instance> sample;
  for (const Instance& instance : first)
    if (takes_part(solver, instance) &&
        (is_symmetric(instance.problem) || !may_fail(solver, Trait::Asymmetric)))
      sample.push_back(instance);
  return sample;
}

}  // namespace

TEST_CASE("every solver: the same problem gives the same bits", "[conformance]") {
  for (const Solver& solver : chosen(all_solvers()))
    for (const Instance& instance : sample_for(solver)) {
      const ContactState first = solve_with_proofs(instance.problem, solver);
      const ContactState second = solve_with_proofs(instance.problem, solver);
      CAPTURE(solver.name, instance.name);
      CHECK(first.force == second.force);
      CHECK(first.gap == second.gap);
      CHECK(first.friction == second.friction);
      CHECK(first.slip == second.slip);
      CHECK(first.amplitude == second.amplitude);
      CHECK(first.active() == second.active());
      CHECK(first.report.status == second.report.status);
      CHECK(first.report.iterations == second.report.iterations);
    }
}

TEST_CASE("every solver: units and scales of rows change no bit but the exponent",
          "[conformance][units]") {
  // Roots of powers of 4 are exact, so that equilibrated data are the same numbers, but for pairs that
  // cannot move: these have nothing to be scaled by.
  for (const Solver& solver : chosen(all_solvers())) {
    if (std::string(solver.name) == "friction_split_literal")
      continue;  // nothing is scaled, as printed
    for (const Instance& instance : sample_for(solver)) {
      if (!is_symmetric(instance.problem) ||
          (instance.problem.compliance.diagonal().array() == 0).any())
        continue;
      const Index n = instance.problem.free_gap.size();
      VectorXd row(n);
      for (Index i = 0; i < n; ++i) row(i) = std::ldexp(1, static_cast<int>((7 * i + 3) % 61) - 30);
      const double length = 0x1p20;
      const double force = 0x1p-30;
      const ContactState plain = solve_with_proofs(instance.problem, solver);
      const ContactState other =
          solve_with_proofs(in_units(with_rows(instance.problem, row), length, force), solver);
      CAPTURE(solver.name, instance.name);
      CHECK(other.report.status == plain.report.status);
      CHECK(other.report.iterations == plain.report.iterations);
      CHECK(other.active() == plain.active());
      if (plain.report.status != SolveStatus::Solved) continue;
      CHECK(other.force.cwiseProduct(row) / force == plain.force);
      CHECK(other.gap.cwiseQuotient(row) / length == plain.gap);
      const VectorXd units_of_slips = row(plain.frictional_pairs);
      CHECK(other.friction.cwiseProduct(units_of_slips) / force == plain.friction);
      CHECK(other.slip.cwiseQuotient(units_of_slips) / length == plain.slip);
      CHECK(other.amplitude / length == plain.amplitude);
      CHECK(other.contact_status == plain.contact_status);
    }
  }
}

TEST_CASE("every solver: a pair written twice gives one total force or an honest refusal",
          "[conformance][hard]") {
  Eigen::Matrix3d G;
  G << 2, 2, 1, 2, 2, 1, 1, 1, 2;
  const ContactProblem problem{G, Eigen::Vector3d(-2, -2, 5)};
  for (const Solver& solver : chosen(solvers())) {
    const ContactState state = solver.solve(problem, {});
    CAPTURE(solver.name);
    if (state.report.status == SolveStatus::Solved)
      CHECK(state.force(0) + state.force(1) == Approx(1).epsilon(1e-12));
    else
      CHECK(may_fail(solver, Trait::Dependent));
  }
}

TEST_CASE("every solver: a limit on iterations is kept, or not needed", "[conformance]") {
  for (const Solver& solver : chosen(solvers())) {
    const ContactProblem problem = half_plane_indentation(12).problem;
    SolverOptions options;
    options.iteration_limit = 1;
    const ContactState state = solver.solve(problem, options);
    CAPTURE(solver.name);
    CHECK((state.report.status == SolveStatus::Solved ||
           state.report.status == SolveStatus::IterationLimit));
  }
}

TEST_CASE("every solver: a bad problem is the caller's mistake", "[conformance]") {
  const double nan = std::nan("");
  for (const Solver& solver : chosen(solvers())) {
    CAPTURE(solver.name);
    CHECK_THROWS_AS(solver.solve({Eigen::MatrixXd::Identity(2, 2), VectorXd::Zero(3)}, {}),
                    std::invalid_argument);
    CHECK_THROWS_AS(solver.solve({Eigen::MatrixXd::Identity(1, 1), VectorXd::Constant(1, nan)}, {}),
                    std::invalid_argument);
    CHECK_THROWS_AS(solver.solve({Eigen::MatrixXd::Constant(1, 1, nan), VectorXd::Zero(1)}, {}),
                    std::invalid_argument);
  }
}

TEST_CASE("every solver: an effect that it does not take is refused, not left out",
          "[conformance][friction][floating]") {
  // One pair, pressed by 1 and pulled aside by 1; held, or on a mode that presses it.
  const ContactProblem frictional{Eigen::Matrix2d::Identity(), VectorXd::Constant(1, -1),
                                  VectorXd::Constant(1, 1),
                                  law_of_all(VectorXd::Ones(1), VectorXd::Zero(1))};
  const ContactProblem floats{Eigen::MatrixXd::Identity(1, 1), VectorXd::Ones(1), {}, {},
                              Eigen::MatrixXd::Ones(1, 1),     VectorXd::Ones(1)};
  for (const Solver& solver : all_solvers()) {
    CAPTURE(solver.name);
    if (solver.friction == Takes::No)
      CHECK_THROWS_AS(solver.solve(frictional, {}), std::invalid_argument);
    else
      CHECK_NOTHROW(solver.solve(frictional, {}));
    if (solver.rigid_modes)
      CHECK_NOTHROW(solver.solve(floats, {}));
    else
      CHECK_THROWS_AS(solver.solve(floats, {}), std::invalid_argument);
  }
}

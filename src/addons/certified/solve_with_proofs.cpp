#include "addons/certified/solve_with_proofs.hpp"

#include <vector>

#include "addons/certified/at_rest.hpp"
#include "addons/certified/proofs.hpp"
#include "addons/certified/soft_pairs.hpp"
#include "signorini/solvers/fischer_burmeister.hpp"
#include "signorini/solvers/portfolio.hpp"
#include "signorini/solvers/quasi_active_set.hpp"

namespace signorini {
namespace {

/// A member that names others, with those of this add-on that the problem is for before them.
Solver strengthened(const Solver& solver, const ContactProblem& problem) {
  Solver strong = solver;
  strong.others = asked_after(solver);
  if (solver.others.empty()) return strong;
  if (!problem.law.pair.empty()) strong.others.insert(strong.others.begin(), soft_pairs);
  if (problem.resultant.size() > 0) strong.others.insert(strong.others.begin(), at_rest);
  return strong;
}

/// Forces, movements and amplitudes of a solution, as its set has them.
ActiveSetSolution solution_of(const ScaledProblem& scaled, const ContactProblem& problem,
                              const ContactState& state) {
  ActiveSetSolution start;
  start.force.resize(scaled.free.size());
  start.force << state.force, state.friction;
  start.force.array() /= scaled.scale.array();
  start.amplitude.setZero(scaled.rigid.cols());
  if (scaled.rigid.cols() > 0)
    start.amplitude =
        scaled.rigid.transpose() * scaled.scale.cwiseProduct(problem.rigid * state.amplitude);
  return solve_active_set(scaled, all_statuses(state), &start);
}

void prove_uniqueness(const ContactProblem& problem, ContactState& state) {
  const ScaledProblem scaled =
      problem.resultant.size() > 0 ? equilibrate(problem) : equilibrate_any(problem);
  if (!scaled.symmetric) return;
  const std::vector<ContactStatus> statuses = all_statuses(state);
  const ActiveSetSolution solution = solution_of(scaled, problem, state);
  state.uniqueness = uniqueness(scaled, statuses, solution);
  if (state.uniqueness == Uniqueness::Doubtful)
    state.uniqueness_warning = uniqueness_warning(scaled, statuses, solution);
}

}  // namespace

std::vector<Solver (*)()> asked_after(const Solver& solver) {
  std::vector<Solver (*)()> members;
  for (Solver (*const next)() : solver.others) {
    members.push_back(next);
    if (next == static_cast<Solver (*)()>(quasi_active_set)) members.push_back(fischer_burmeister);
  }
  return members;
}

ContactState solve_with_proofs(const ContactProblem& problem, const Solver& solver,
                               const SolverOptions& options) {
  const bool frictional = !problem.law.pair.empty();
  const bool floats = problem.resultant.size() > 0;
  if (floats && (!frictional || solver.friction != Takes::No))
    if (auto away = infeasible_resultant(problem, equilibrate(problem))) return *away;
  ContactState state = solve(problem, strengthened(solver, problem), options);
  const SolveStatus status = state.report.status;
  if (frictional && status == SolveStatus::Solved) prove_uniqueness(problem, state);
  if (frictional || floats || status == SolveStatus::Solved || status == SolveStatus::Infeasible)
    return state;
  const ScaledProblem scaled = equilibrate_any(problem);
  if (!scaled.symmetric) state.farkas_certificate = farkas_certificate(scaled);
  if (state.farkas_certificate.size() > 0) state.report.status = SolveStatus::Infeasible;
  return state;
}

}  // namespace signorini

#include "signorini/solvers/portfolio.hpp"

#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/solvers/augmented_lagrangian.hpp"

namespace signorini {
namespace {

/// Whether a method ended without a word on the problem itself, so that another one may do better.
bool lost(const ContactState& state) {
  const SolveStatus status = state.report.status;
  return status == SolveStatus::Breakdown || status == SolveStatus::IterationLimit ||
         status == SolveStatus::Ray;
}

/// Puts the runs so far before a claim.
ContactState after(Report report, ContactState claim) {
  append(report, claim.report);
  claim.report = std::move(report);
  return claim;
}

}  // namespace

ContactState solve(const ContactProblem& problem, const Solver& solver,
                   const SolverOptions& options) {
  const bool frictional = !problem.law.pair.empty();
  const bool springs = problem.resultant.size() > 0 && !frictional;
  require_input(!frictional || solver.friction != Takes::No, "solver '", solver.name,
                "' takes no friction: take 'primal_dual_active_set'");
  ContactState state;
  if (!springs || solver.rigid_modes) {
    state = solver.solve(problem, options);
    for (Solver (*const next)() : solver.others) {
      const Solver other = next();
      if (!lost(state) || options.iteration_limit > 0) break;
      if (takes(other, problem) && (problem.resultant.size() == 0 || other.rigid_modes))
        state = after(std::move(state.report), other.solve(problem, options));
    }
    if (!springs || !lost(state)) return state;
  }
  const auto held = [&](const ContactProblem& on_springs) {
    return solve(on_springs, solver, options);
  };
  return after(std::move(state.report), augmented_lagrangian(problem, held));
}

}  // namespace signorini

// # A portfolio of methods
//
// No method for contact is both fast and sure. The primal-dual active set needs a few sets and may
// cycle. Lemke's method does not cycle and may take a long path. A *portfolio* runs them one after
// the other until one solves the problem. This needs somebody who knows whether a problem is
// solved: every claim of a member is checked by its certificate, which is computed from the data.
// So a wrong claim costs time and does no harm.
//
// The order is a matter of time alone, as long as there is one solution. Each member names those to
// ask after it.

#include "signorini/solvers/portfolio.hpp"

#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/solvers/augmented_lagrangian.hpp"

namespace signorini {
namespace {

// Puts the runs so far before a claim, so that the report shows all that was tried.
ContactState after(Report report, ContactState claim) {
  append(report, claim.report);
  claim.report = std::move(report);
  return claim;
}

}  // namespace

// A proof that nothing solves the problem is an answer, and no other member is asked. A ray may be
// the fault of the path.
bool lost(const ContactState& state) {
  const SolveStatus status = state.report.status;
  return status == SolveStatus::Breakdown || status == SolveStatus::IterationLimit ||
         status == SolveStatus::Ray;
}

// Bodies with rigid modes and without friction are a special case. A member that takes them is
// asked with the others. If they all fail, or if the member takes only held bodies,
// augmented_lagrangian() makes held problems of it, and each of these is solved by this same
// function.
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

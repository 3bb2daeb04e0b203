#include "addons/certified/members.hpp"

#include <utility>
#include <vector>

#include "signorini/solvers/goldfarb_idnani.hpp"
#include "signorini/solvers/iterate.hpp"

namespace signorini {
namespace {

using Eigen::MatrixXd;

/// Moves the bodies apart, and takes that as the end if it is a solution.
void put_apart(const ScaledProblem& problem, Iterate& iterate) {
  const MatrixXd U = problem.rigid.topRows(problem.pairs());
  const ContactState placed =
      goldfarb_idnani(ContactProblem{U * U.transpose(), problem.free.head(U.rows())});
  append(iterate.report, placed.report);
  iterate.stop(SolveStatus::Breakdown);
  if (placed.report.status != SolveStatus::Solved) return;
  ActiveSetSolution start;
  start.amplitude = U.transpose() * placed.force;
  const std::vector<ContactStatus> open = statuses_of({}, U.rows());
  ActiveSetSolution end = solve_active_set(problem, open, &start);
  if (!solves(problem, open, end)) return;
  iterate.solution = std::move(end);
  iterate.statuses = open;
  iterate.confirmed = true;
}

ContactState solve_at_rest(const ContactProblem& problem, const SolverOptions& /*options*/) {
  const ScaledProblem scaled = equilibrate(problem);
  Iterate iterate = first_iterate(scaled);
  if (scaled.resultant.isZero(0)) put_apart(scaled, iterate);
  return finished(problem, scaled, std::move(iterate));
}

}  // namespace

Solver at_rest() {
  return Solver{"at_rest", "bodies that nothing pushes move apart", solve_at_rest}
      .may_fail_on({Trait::Ordinary, Trait::Asymmetric})
      .with_friction(Takes::Also)
      .with_rigid_modes();
}

}  // namespace signorini

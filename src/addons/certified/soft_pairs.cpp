#include "addons/certified/members.hpp"

#include <utility>

#include "signorini/core/rounding.hpp"
#include "signorini/solvers/iterate.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"

namespace signorini {
namespace {

using Eigen::Index;

// These numbers trade exchanges that lead nowhere for steps of softness that are too small. Whether an end is a
// solution does not depend on them: each is confirmed exactly on the pairs as they are.

/// Exchanges for one softness: those that settle need few.
constexpr Index few = 10;

/// Exchanges that try to end where soft pairs no longer change: it ends at once, or for other reasons.
constexpr Index last_few = 3;

/// What softness is multiplied by where the pairs settle, and where they do not.
constexpr double harder = 0.5;
constexpr double softer = 4;

/// Exchanges from where an iterate stands. \param report  gets them added
Iterate exchanged(const ScaledProblem& problem, const Iterate& from, Index limit, Report& report) {
  Iterate next{from.solution, from.statuses, {}};
  primal_dual_iterations(problem, limit, next);
  append(report, next.report);
  return next;
}

/// Makes pairs soft, and less and less so. \param iterate  where to start; kept but for its report unless this is the end
void follow_soft_pairs(const ScaledProblem& problem, Iterate& iterate) {
  const Index most = iterate.report.iterations + most_exchanges(problem) + 2 * problem.free.size();
  ScaledProblem soft = problem;
  Iterate at{iterate.solution, iterate.statuses, {}};
  for (double softness = 1; softness > epsilon && iterate.report.iterations < most;) {
    soft.compliance.diagonal() = problem.compliance.diagonal().array() + softness;
    for (Index i = 0; i < soft.sparse.cols(); ++i)
      soft.sparse.coeffRef(i, i) = soft.compliance(i, i);
    soft.free = problem.free - softness * at.solution.force;
    Iterate next = exchanged(soft, at, few, iterate.report);
    softness *= next.confirmed ? harder : softer;
    if (!next.confirmed) continue;
    at = std::move(next);
    if (at.report.iterations > 1) continue;
    Iterate end = exchanged(problem, at, last_few, iterate.report);
    if (!end.confirmed) continue;
    end.report = std::move(iterate.report);
    iterate = std::move(end);
    return;
  }
}

ContactState solve_soft_pairs(const ContactProblem& problem, const SolverOptions& /*options*/) {
  const ScaledProblem scaled =
      problem.resultant.size() > 0 ? equilibrate(problem) : equilibrate_any(problem);
  Iterate iterate = first_iterate(scaled);
  follow_soft_pairs(scaled, iterate);
  return finished(problem, scaled, std::move(iterate));
}

}  // namespace

Solver soft_pairs() {
  return Solver{"soft_pairs", "pairs that give way less and less", solve_soft_pairs}
      .may_fail_on({Trait::Friction})
      .with_friction(Takes::Only)
      .with_rigid_modes();
}

}  // namespace signorini

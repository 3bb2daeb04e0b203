#include "signorini/solvers/primal_dual_active_set.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "signorini/solvers/coarse_iterate.hpp"
#include "signorini/solvers/fischer_burmeister.hpp"
#include "signorini/solvers/lemke.hpp"
#include "signorini/solvers/quasi_active_set.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// What statuses say is closed, the pairs that overlapped most first.
ActiveSet deepest_first(const ScaledProblem& problem, const Iterate& iterate) {
  ActiveSet set = active_set(iterate.statuses, problem.law);
  if (!problem.law.pair.empty()) return set;
  const VectorXd& movement = iterate.solution.movement;
  std::stable_sort(set.closed.begin(), set.closed.end(),
                   [&](Index i, Index j) { return movement(i) < movement(j); });
  return set;
}

/// Leaves the first difference between two lists alone.
void keep_first_change(const std::vector<ContactStatus>& last, std::vector<ContactStatus>& next) {
  std::size_t i = 0;
  while (i < next.size() && next[i] == last[i]) ++i;
  for (++i; i < next.size(); ++i) next[i] = last[i];
}

}  // namespace

Index most_exchanges(const ScaledProblem& problem) {
  return problem.law.pair.empty() ? 10 * problem.pairs() + 10 : 50;
}

void primal_dual_iterations(const ScaledProblem& problem, Index limit, Iterate& iterate) {
  const bool frictional = !problem.law.pair.empty();
  const bool plain = !frictional && problem.rigid.cols() == 0;
  const double unit = force_scale(problem);
  std::set<std::vector<ContactStatus>> seen;
  bool one_at_a_time = false;
  ActiveSetSolution start = iterate.solution;
  iterate.stop(SolveStatus::IterationLimit, "the motions did not settle");
  for (Index step = 0; step < limit; ++step) {
    if (!seen.insert(iterate.statuses).second) {
      iterate.reason = "the motions run in circles";
      one_at_a_time = true;
      if (!plain) return;
    }
    const ActiveSet set = deepest_first(problem, iterate);
    iterate.solve(problem, set, plain ? nullptr : &start);
    const ActiveSetSolution& now = iterate.solution;
    if (frictional) start = now;
    if (!now.force.allFinite() || !now.movement.allFinite() || (!frictional && !now.solvable))
      return iterate.stop(SolveStatus::Breakdown, "the equations of the motions are singular");
    const bool dependent = !frictional && now.rows.size() < set.closed.size();
    if (dependent && one_at_a_time) return iterate.stop(SolveStatus::Breakdown);
    if (dependent) iterate.statuses = statuses_of(now.rows, problem.pairs());
    std::vector<ContactStatus> next = iterate.statuses;
    const Index changes = predict(problem, now, unit, next);
    iterate.report.history.push_back(summary(problem, iterate.statuses, now, changes));
    if (changes == 0) {
      iterate.confirmed = solves(problem, iterate.statuses, now);
      return iterate.confirmed ? void() : iterate.stop(SolveStatus::Breakdown);
    }
    if (one_at_a_time) keep_first_change(iterate.statuses, next);
    if (step + 1 < limit) iterate.statuses = std::move(next);
  }
}

ContactState primal_dual_active_set(const ContactProblem& problem, const SolverOptions& options) {
  const bool frictional = !problem.law.pair.empty();
  const ScaledProblem scaled =
      frictional && problem.resultant.size() == 0 ? equilibrate_any(problem) : equilibrate(problem);
  const Index asked = options.iteration_limit;
  const Index most = most_exchanges(scaled);
  const Index limit = asked == 0 ? most : frictional ? asked : std::min(asked, most);
  const bool warm = static_cast<Index>(options.start.size()) == scaled.pairs();
  Iterate iterate = warm ? iterate_from(scaled, options.start) : coarse_iterate(scaled);
  primal_dual_iterations(scaled, limit, iterate);
  if (warm && asked == 0 && !iterate.confirmed) {
    Iterate again = coarse_iterate(scaled);
    append(again.report, iterate.report);
    iterate = std::move(again);
    primal_dual_iterations(scaled, limit, iterate);
  }
  return finished(problem, scaled, std::move(iterate));
}

Solver primal_dual_active_set() {
  return Solver{
      "primal_dual_active_set",
      "whole groups of pairs change what they do; another method where that does not arrive",
      primal_dual_active_set}
      .may_fail_on({Trait::Asymmetric})
      .with_friction(Takes::Also)
      .with_rigid_modes()
      .before({quasi_active_set, fischer_burmeister, lemke});
}

}  // namespace signorini

#include "signorini/solvers/primal_dual_active_set.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "addons/certified/proofs.hpp"
#include "signorini/solvers/goldfarb_idnani.hpp"
#include "signorini/solvers/newton.hpp"
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

/// How many sets the exchange without friction may look at.
Index most_exchanges(const ScaledProblem& problem) { return 10 * problem.pairs() + 10; }

/// Fewer overlapping pairs than these are exchanged as fast as a start for them is found.
constexpr std::size_t many = 64;

/// Where to start from without friction and rigid modes. Of many overlapping pairs most will open: every second one
/// is solved alone first, by the same rule, and those between closed ones are closed.
Iterate coarse_iterate(const ScaledProblem& problem) {
  Iterate iterate = first_iterate(problem);
  const std::vector<Index> overlapping = closed_pairs(iterate.statuses);
  if (overlapping.size() < many) return iterate;
  std::vector<Index> half;
  for (std::size_t k = 0; k < overlapping.size(); k += 2) half.push_back(overlapping[k]);
  const ScaledProblem coarse{problem.compliance(half, half), problem.free(half),
                             problem.scale(half), problem.symmetric};
  Iterate found = coarse_iterate(coarse);
  primal_dual_iterations(coarse, most_exchanges(coarse), found);
  iterate.report.factorisations = found.report.factorisations;
  if (!found.confirmed) return iterate;
  const auto opens = [&](std::size_t k) {
    return found.statuses[std::min(k, half.size() - 1)] == ContactStatus::Open;
  };
  for (std::size_t k = 0; k < overlapping.size(); ++k)
    if (opens(k / 2) || opens((k + 1) / 2))
      iterate.statuses[static_cast<std::size_t>(overlapping[k])] = ContactStatus::Open;
  return iterate;
}

/// Where to start from if a problem like this one is solved.
Iterate iterate_from(const ScaledProblem& problem, const std::vector<ContactStatus>& statuses) {
  Iterate iterate;
  iterate.solution.force.setZero(problem.free.size());
  iterate.solution.movement = problem.free;
  iterate.solution.amplitude.setZero(problem.rigid.cols());
  iterate.statuses = statuses;
  return iterate;
}

/// Ends where nothing pushes bodies that only contact stops: no pair has a force, at the least of the rigid motions
/// after which none overlaps. Where so many pairs just touch, exchanges follow forces that are nothing but rounding.
void put_apart(const ScaledProblem& problem, Iterate& iterate) {
  if (!problem.resultant.isZero(0)) return;
  const Index pairs = problem.pairs();
  const Eigen::MatrixXd U = problem.rigid.topRows(pairs);
  const ContactState placed = goldfarb_idnani({U * U.transpose(), problem.free.head(pairs)});
  append(iterate.report, placed.report);
  iterate.report.status = SolveStatus::Breakdown;
  if (placed.report.status != SolveStatus::Solved) return;
  ActiveSetSolution start;
  start.amplitude = U.transpose() * placed.force;
  const std::vector<ContactStatus> open = statuses_of({}, pairs);
  ActiveSetSolution end = solve_active_set(problem, open, &start);
  if (!solves(problem, open, end)) return;
  iterate.solution = std::move(end);
  iterate.statuses = open;
  iterate.confirmed = true;
}

}  // namespace

void primal_dual_iterations(const ScaledProblem& problem, Index limit, Iterate& iterate) {
  const double unit = force_scale(problem);
  const bool frictional = !problem.law.pair.empty();
  const bool plain = !frictional && problem.rigid.cols() == 0;
  std::set<std::vector<ContactStatus>> seen;
  bool one_at_a_time = false;
  Report& report = iterate.report;
  report.status = SolveStatus::IterationLimit;
  iterate.reason = "the motions did not settle";
  ActiveSetSolution start = iterate.solution;
  for (Index step = 0; step < limit; ++step) {
    if (!seen.insert(iterate.statuses).second) {
      iterate.reason = "the motions run in circles";
      one_at_a_time = true;
      if (!plain) return;
    }
    const ActiveSet set = deepest_first(problem, iterate);
    report.factorisations += set.closed.empty() ? 0 : 1;
    ++report.iterations;
    iterate.solution = solve_active_set(problem, set, plain ? nullptr : &start);
    const ActiveSetSolution& now = iterate.solution;
    if (frictional) start = now;
    if (!now.force.allFinite() || !now.movement.allFinite() || (!frictional && !now.solvable)) {
      report.status = SolveStatus::Breakdown;
      iterate.reason = "the equations of the motions are singular";
      return;
    }
    if (!frictional &&
        now.rows.size() < set.closed.size()) {  // the others repeat those that stay closed
      if (one_at_a_time) {
        report.status = SolveStatus::Breakdown;
        return;
      }
      iterate.statuses = statuses_of(now.rows, problem.pairs());
    }
    std::vector<ContactStatus> next = iterate.statuses;
    const Index changes = predict(problem, now, unit, next);
    report.history.push_back(summary(problem, iterate.statuses, now, changes));
    if (changes == 0) iterate.confirmed = solves(problem, iterate.statuses, now);
    if (iterate.confirmed) return;
    if (changes == 0) {
      report.status = SolveStatus::Breakdown;
      return;
    }
    if (one_at_a_time) keep_first_change(iterate.statuses, next);
    if (step + 1 < limit) iterate.statuses = std::move(next);
  }
}

ContactState primal_dual_active_set(const ContactProblem& problem, const SolverOptions& options) {
  const bool frictional = !problem.law.pair.empty();
  const bool floats = problem.resultant.size() > 0;
  const ScaledProblem scaled =
      !frictional || floats ? equilibrate(problem) : equilibrate_any(problem);
  if (auto away = infeasible_resultant(problem, scaled)) return *away;
  const Index asked = options.iteration_limit;
  const Index own_limit = frictional ? exchange_limit : most_exchanges(scaled);
  const Index limit = asked > 0 ? std::min(asked, frictional ? asked : own_limit) : own_limit;
  std::optional<Iterate> first;
  const auto cold = [&] {
    if (!first) first = frictional || floats ? first_iterate(scaled) : coarse_iterate(scaled);
    return *first;
  };
  const bool warm = static_cast<Index>(options.start.size()) == scaled.pairs();
  Iterate iterate = warm ? iterate_from(scaled, options.start) : cold();
  primal_dual_iterations(scaled, limit, iterate);
  const auto begin_again = [&] {
    Iterate again = cold();
    again.report = std::move(iterate.report);
    iterate = std::move(again);
  };
  if (warm && asked == 0 && !iterate.confirmed) {
    begin_again();
    primal_dual_iterations(scaled, limit, iterate);
  }
  if ((frictional || floats) && asked == 0 && !iterate.confirmed) {
    begin_again();
    if (floats) put_apart(scaled, iterate);
    if (frictional && !iterate.confirmed) follow_soft_pairs(scaled, iterate);
    const Index most = iterate.report.iterations + newton_limit;
    if (!iterate.confirmed) follow_newton(scaled, nested_friction, most, iterate);
    if (!iterate.confirmed) follow_pivots(scaled, {}, iterate);
  }
  ContactState state = finished(problem, scaled, std::move(iterate));
  const Index left = asked - state.report.iterations;
  if (frictional || floats || state.report.status == SolveStatus::Solved ||
      (asked > 0 && left <= 0))
    return state;
  SolverOptions rest = options;
  rest.iteration_limit = asked > 0 ? left : 0;
  ContactState other = quasi_active_set(problem, rest);
  append(state.report, other.report);
  other.report = std::move(state.report);
  return other;
}

Solver primal_dual_active_set() {
  return Solver{
      "primal_dual_active_set",
      "whole groups of pairs change what they do; another method where that does not arrive",
      primal_dual_active_set}
      .may_fail_on({Trait::Asymmetric})
      .with_friction(Takes::Also)
      .with_rigid_modes()
      .before({fischer_burmeister, lemke});
}

}  // namespace signorini

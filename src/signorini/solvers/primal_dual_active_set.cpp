#include "signorini/solvers/primal_dual_active_set.hpp"

#include <algorithm>
#include <set>

#include "signorini/closing/closed_pairs.hpp"
#include "signorini/problem/report_sum.hpp"
#include "signorini/solvers/quasi_active_set.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Membership = std::vector<bool>;

std::vector<Index> members(const Membership& closed) {
  std::vector<Index> list;
  for (std::size_t i = 0; i < closed.size(); ++i)
    if (closed[i]) list.push_back(static_cast<Index>(i));
  return list;
}

/// Pairs on the wrong side: closed ones in tension and open ones that overlap.
std::vector<Index> wrong_pairs(const Membership& closed, const ClosedPairs& now) {
  std::vector<Index> wrong;
  for (std::size_t k = 0; k < closed.size(); ++k) {
    const Index i = static_cast<Index>(k);
    const bool is_wrong =
        closed[k] ? now.force(i) < -now.force_rounding(i) : now.gap(i) < -now.gap_rounding(i);
    if (is_wrong) wrong.push_back(i);
  }
  return wrong;
}

Iteration summary(const ScaledProblem& scaled, const ClosedPairs& now, Index active,
                  Index changes) {
  const Eigen::VectorXd force = scaled.scale.cwiseProduct(now.force);
  const Eigen::VectorXd gap = now.gap.cwiseQuotient(scaled.scale);
  // gap = d + G lambda, so -d.lambda - 1/2 lambda.G lambda = -1/2 lambda.(d + gap)
  const double dual_energy = -0.5 * now.force.dot(scaled.free_gap + now.gap);
  return {active, changes, std::max(0.0, -gap.minCoeff()), std::max(0.0, -force.minCoeff()),
          dual_energy};
}

/// Opens pairs of a dependent set until the rest is independent; those that overlapped most stay closed.
void keep_independent(const ScaledProblem& scaled, const Eigen::VectorXd& last_gap,
                      Membership& closed) {
  std::vector<Index> wanted = members(closed);
  std::stable_sort(wanted.begin(), wanted.end(),
                   [&](Index i, Index j) { return last_gap(i) < last_gap(j); });
  closed.assign(closed.size(), false);
  for (const Index i : independent_pairs(scaled, wanted))
    closed[static_cast<std::size_t>(i)] = true;
}

/// The exchange of sets, to its end.
ContactState exchanged(const ScaledProblem& scaled, Index limit) {
  const Index n = scaled.free_gap.size();
  Membership closed(static_cast<std::size_t>(n));
  for (Index i = 0; i < n; ++i) closed[static_cast<std::size_t>(i)] = scaled.free_gap(i) < 0;
  std::set<Membership> seen;
  bool one_at_a_time = false;
  Report report;
  ClosedPairs now;
  Eigen::VectorXd last_gap = scaled.free_gap;
  while (true) {
    std::vector<Index> active = members(closed);
    now = close_pairs(scaled, active);
    ++report.iterations;
    report.factorisations += active.empty() ? 0 : 1;
    if (!now.solvable && !one_at_a_time) {
      keep_independent(scaled, last_gap, closed);
      active = members(closed);
      now = close_pairs(scaled, active);
      report.factorisations += active.empty() ? 0 : 1;
    }
    if (!now.solvable) {
      report.status = Status::Breakdown;
      now.gap = scaled.free_gap;
      break;
    }
    const std::vector<Index> wrong = wrong_pairs(closed, now);
    if (n > 0)
      report.history.push_back(summary(scaled, now, static_cast<Index>(active.size()),
                                       static_cast<Index>(wrong.size())));
    if (wrong.empty()) {
      report.status = solves(scaled, now) ? Status::Solved : Status::Breakdown;
      break;
    }
    if (report.iterations >= limit) {
      report.status = Status::IterationLimit;
      break;
    }
    one_at_a_time = one_at_a_time || !seen.insert(closed).second;
    for (const Index i : wrong) {
      closed[static_cast<std::size_t>(i)].flip();
      if (one_at_a_time) break;
    }
    last_gap = now.gap;
  }
  return unscaled(scaled, now, members(closed), report);
}

}  // namespace

ContactState primal_dual_active_set(const ContactProblem& problem, const SolverOptions& options) {
  const ScaledProblem scaled = equilibrate(problem);
  const Index own_limit = 10 * problem.free_gap.size() + 10;
  const Index limit = options.iteration_limit > 0 ? options.iteration_limit : own_limit;
  ContactState state = certified(problem, exchanged(scaled, std::min(limit, own_limit)));
  const Index left = limit - state.report.iterations;
  if (state.report.status == Status::Solved || (options.iteration_limit > 0 && left <= 0))
    return state;
  SolverOptions rest = options;
  rest.iteration_limit = options.iteration_limit > 0 ? left : 0;
  ContactState other = quasi_active_set(problem, rest);
  append(state.report, other.report);
  other.report = std::move(state.report);
  return other;
}

}  // namespace signorini

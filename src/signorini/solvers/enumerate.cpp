#include "signorini/solvers/enumerate.hpp"

#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/problem/farkas.hpp"

namespace signorini {

using Eigen::Index;

namespace {

std::vector<Index> members(unsigned set, Index n) {
  std::vector<Index> list;
  for (Index i = 0; i < n; ++i)
    if ((set >> i & 1U) != 0) list.push_back(i);
  return list;
}

/// The proof that nothing solves a problem, or nothing: one that no smaller one is part of has independent
/// pairs and one that depends on them.
Eigen::VectorXd proof(const ScaledProblem& scaled) {
  const Index n = scaled.free.size();
  for (unsigned set = 0; set < (1U << n); ++set)
    for (Index pair = 0; pair < n; ++pair) {
      if ((set >> pair & 1U) != 0) continue;
      Eigen::VectorXd y = farkas_certificate(scaled, members(set, n), pair);
      if (y.size() > 0) return y;
    }
  return {};
}

}  // namespace

ContactState enumerate(const ContactProblem& problem, const SolverOptions& /*options*/) {
  check_plain(problem, "enumerate");
  const Index n = problem.free_gap.size();
  require_argument(n <= largest_enumeration, "enumerate: accepts at most ", largest_enumeration,
                   " pairs, got ", n);
  const ScaledProblem scaled = equilibrate_any(problem);
  Report report;
  ActiveSetSolution best;
  best.force.setZero(n);
  best.movement = scaled.free;
  std::vector<Index> best_active;
  for (unsigned set = 0; set < (1U << n); ++set) {
    const std::vector<Index> active = members(set, n);
    if (report.status == SolveStatus::Solved && active.size() >= best_active.size()) continue;
    ActiveSetSolution now = solve_active_set(scaled, ActiveSet{active});
    ++report.iterations;
    report.factorisations += active.empty() ? 0 : 1;
    if (now.rows.size() < active.size() || !solves(scaled, statuses_of(active, n), now)) continue;
    best = std::move(now);
    best_active = active;
    report.status = SolveStatus::Solved;
  }
  Eigen::VectorXd y;
  if (report.status != SolveStatus::Solved && scaled.symmetric) y = proof(scaled);
  if (y.size() > 0) report.status = SolveStatus::Infeasible;
  return finished(problem, scaled, best, statuses_of(best_active, n), std::move(report),
                  std::move(y));
}

}  // namespace signorini

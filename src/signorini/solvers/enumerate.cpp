#include "signorini/solvers/enumerate.hpp"

#include <utility>

#include "signorini/closing/closed_pairs.hpp"
#include "signorini/core/errors.hpp"

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
  const Index n = scaled.free_gap.size();
  for (unsigned set = 0; set < (1U << n); ++set)
    for (Index pair = 0; pair < n; ++pair) {
      if ((set >> pair & 1U) != 0) continue;
      Eigen::VectorXd y = contradiction(scaled, members(set, n), pair);
      if (y.size() > 0) return y;
    }
  return {};
}

}  // namespace

ContactState enumerate(const ContactProblem& problem, const SolverOptions& /*options*/) {
  const Index n = problem.free_gap.size();
  require(n <= largest_enumeration, "enumerate: accepts at most ", largest_enumeration,
          " pairs, got ", n);
  const ScaledProblem scaled = equilibrate_any(problem);
  Report report;
  ClosedPairs best;
  best.force.setZero(n);
  best.gap = scaled.free_gap;
  std::vector<Index> best_active;
  for (unsigned set = 0; set < (1U << n); ++set) {
    const std::vector<Index> active = members(set, n);
    if (report.status == Status::Solved && active.size() >= best_active.size()) continue;
    const ClosedPairs now = close_pairs(scaled, active);
    ++report.iterations;
    report.factorisations += active.empty() ? 0 : 1;
    if (!solves(scaled, now)) continue;
    best = now;
    best_active = active;
    report.status = Status::Solved;
  }
  ContactState state = unscaled(scaled, best, best_active, report);
  if (report.status != Status::Solved) state.infeasibility = proof(scaled);
  if (state.infeasibility.size() > 0) state.report.status = Status::Infeasible;
  return certified(problem, std::move(state));
}

}  // namespace signorini

#include "signorini/complementarity/enumerate.hpp"

#include <cmath>
#include <limits>

#include "signorini/complementarity/closed_pairs.hpp"
#include "signorini/core/errors.hpp"

namespace signorini {

using Eigen::Index;

namespace {

/// Whether only rounding keeps a set from being a solution, but half of the digits of its gaps are right,
/// as they are not in a block that passed as regular because of rounding.
bool nearly_solves(const ScaledProblem& problem, const ClosedPairs& closed) {
  return (closed.force.array() >= -closed.force_rounding.array()).all() &&
         (closed.gap.array() >= -closed.gap_rounding.array()).all() &&
         closed.gap_rounding.maxCoeff() <
             -problem.free_gap.minCoeff() * std::sqrt(std::numeric_limits<double>::epsilon());
}

}  // namespace

ContactState enumerate(const ContactProblem& problem, const SolverOptions& /*options*/) {
  const Index n = problem.free_gap.size();
  require(n <= largest_enumeration, "enumerate: accepts at most ", largest_enumeration,
          " pairs, got ", n);
  const ScaledProblem scaled = equilibrate_any(problem);
  Report report;
  report.status = Status::Infeasible;
  ClosedPairs best;
  best.force.setZero(n);
  best.gap = scaled.free_gap;
  std::vector<Index> best_active;
  bool doubtful = false;
  for (unsigned set = 0; set < (1U << n); ++set) {
    std::vector<Index> active;
    for (Index i = 0; i < n; ++i)
      if ((set >> i & 1U) != 0) active.push_back(i);
    if (report.status == Status::Solved && active.size() >= best_active.size()) continue;
    const ClosedPairs now = close_pairs(scaled, active);
    ++report.iterations;
    report.factorisations += active.empty() ? 0 : 1;
    if (!solves(scaled, now)) {
      doubtful = doubtful || (now.solvable ? nearly_solves(scaled, now) : !scaled.symmetric);
      continue;
    }
    best = now;
    best_active = active;
    report.status = Status::Solved;
  }
  if (report.status == Status::Infeasible && doubtful) report.status = Status::Breakdown;
  return certified(problem, unscaled(scaled, best, best_active, report));
}

}  // namespace signorini

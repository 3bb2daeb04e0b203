#include "signorini/complementarity/enumerate.hpp"

#include "signorini/complementarity/closed_pairs.hpp"
#include "signorini/core/errors.hpp"

namespace signorini {

using Eigen::Index;

ContactState enumerate(const ContactProblem& problem, const SolverOptions& /*options*/) {
  const Index n = problem.free_gap.size();
  require(n <= largest_enumeration, "enumerate: accepts at most ", largest_enumeration,
          " pairs, got ", n);
  const ScaledProblem scaled = equilibrate(problem);
  Report report;
  report.status = Status::Infeasible;
  ClosedPairs best;
  best.force.setZero(n);
  best.gap = scaled.free_gap;
  std::vector<Index> best_active;
  for (unsigned set = 0; set < (1U << n); ++set) {
    std::vector<Index> active;
    for (Index i = 0; i < n; ++i)
      if ((set >> i & 1U) != 0) active.push_back(i);
    if (report.status == Status::Solved && active.size() >= best_active.size()) continue;
    const ClosedPairs now = close_pairs(scaled, active);
    ++report.iterations;
    report.factorisations += active.empty() ? 0 : 1;
    if (!solves(scaled, now)) continue;
    best = now;
    best_active = active;
    report.status = Status::Solved;
  }
  return certified(problem, unscaled(scaled, best, best_active, report));
}

}  // namespace signorini

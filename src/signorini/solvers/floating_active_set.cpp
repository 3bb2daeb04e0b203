#include <Eigen/Core>
#include <set>
#include <utility>
#include <vector>

#include "signorini/closing/balanced_pairs.hpp"
#include "signorini/closing/floating_projection.hpp"
#include "signorini/solvers/floating_newton.hpp"

namespace signorini {

using Eigen::Index;

FloatingState primal_dual_active_set(const FloatingProblem& problem, const SolverOptions& options) {
  const ScaledFloating scaled = equilibrate(problem);
  const Index limit = options.iteration_limit > 0 ? options.iteration_limit
                                                  : 10 * scaled.contact.free_gap.size() + 10;
  const FloatingProjection projected(scaled);
  const FloatingPoint point = first_point(projected);
  const Eigen::VectorXd start = projected.amplitude(scaled, point.force, point.motion);
  std::vector<Index> closed = closed_pairs(point);
  std::set<std::vector<Index>> seen;
  Report report;
  BalancedPairs now;
  while (true) {
    now = balance_pairs(scaled, closed, start);
    ++report.iterations;
    report.factorisations += closed.empty() ? 0 : 1;
    if (auto state = certified(problem, scaled, now, report)) return *state;
    std::vector<Index> next = next_set(now);
    Iteration entry{};
    entry.active = static_cast<Index>(now.active.size());
    entry.changes = differences(now.active, next);
    report.history.push_back(entry);
    report.status = report.iterations >= limit ? Status::IterationLimit : Status::Breakdown;
    if (report.iterations >= limit || !now.closed.solvable || !seen.insert(next).second) break;
    closed = std::move(next);
  }
  return unscaled(scaled, now.closed, now.active, now.amplitude, std::move(report));
}

}  // namespace signorini

#include <algorithm>

#include "exercise.hpp"
#include "signorini/problem/active_set_system.hpp"

namespace ex4_3 {

using namespace signorini;
using Eigen::Index;

namespace {

std::vector<Index> wrong_pairs(const std::vector<bool>& closed, const ActiveSetSolution& now) {
  std::vector<Index> wrong;
  for (std::size_t k = 0; k < closed.size(); ++k) {
    const Index i = static_cast<Index>(k);
    if (closed[k] ? now.force(i) < -now.force_rounding
                  : now.movement(i) < -now.movement_rounding(i))
      wrong.push_back(i);
  }
  return wrong;
}

ContactState block_pivoting(const ContactProblem& problem, const SolverOptions& options) {
  const ScaledProblem scaled = equilibrate(problem);
  const Index n = problem.free_gap.size();
  const Index limit = options.iteration_limit > 0 ? options.iteration_limit : 1000 * n + 1000;
  const int patience = 3;  // rounds of whole groups without a new record
  std::vector<bool> closed(static_cast<std::size_t>(n), false);
  std::vector<Index> active;
  Index record = n + 1;
  int left = patience;
  Report report;
  ActiveSetSolution now;
  while (true) {
    active.clear();
    for (Index i = 0; i < n; ++i)
      if (closed[static_cast<std::size_t>(i)]) active.push_back(i);
    now = solve_active_set(scaled, ActiveSet{active});
    ++report.iterations;
    report.factorisations += active.empty() ? 0 : 1;
    if (now.rows.size() < active.size()) {
      report.status = SolveStatus::Breakdown;
      break;
    }
    std::vector<Index> wrong = wrong_pairs(closed, now);
    if (wrong.empty()) {
      report.status = solves(scaled, statuses_of(active, n), now) ? SolveStatus::Solved
                                                                  : SolveStatus::Breakdown;
      break;
    }
    if (report.iterations >= limit) {
      report.status = SolveStatus::IterationLimit;
      break;
    }
    const Index count = static_cast<Index>(wrong.size());
    left = count < record ? patience : left - 1;
    record = std::min(record, count);
    if (left < 0) wrong.assign(1, wrong.back());  // one pair, the one with the highest number
    for (const Index i : wrong) closed[static_cast<std::size_t>(i)].flip();
  }
  return finished(problem, scaled, now, statuses_of(active, n), report);
}

}  // namespace

Solver my_solver() {
  return {"block_pivoting",
          "whole groups of pairs change sides while fewer and fewer are wrong",
          block_pivoting,
          0,
          {Trait::Asymmetric, Trait::Dependent, Trait::Infeasible, Trait::IllConditioned}};
}

}  // namespace ex4_3

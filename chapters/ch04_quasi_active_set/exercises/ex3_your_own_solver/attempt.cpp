#include "exercise.hpp"
#include "signorini/problem/active_set_system.hpp"

namespace ex4_3 {

using namespace signorini;
using Eigen::Index;

namespace {

ContactState block_pivoting(const ContactProblem& problem, const SolverOptions& options) {
  const ScaledProblem scaled = equilibrate(problem);
  const Index n = problem.free_gap.size();
  const Index limit = options.iteration_limit > 0 ? options.iteration_limit : 100 * n + 100;
  std::vector<Index> active;  // pairs taken as closed
  Report report;
  report.status = SolveStatus::IterationLimit;
  ActiveSetSolution now = solve_active_set(scaled, ActiveSet{active});
  while (report.iterations < limit) {
    ++report.iterations;
    // your code here: close `active`, find the pairs on the wrong side, exchange all or one of them;
    // end as Breakdown if the set cannot be closed, as Solved if nothing is wrong and solves() agrees
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

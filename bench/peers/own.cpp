#include <utility>

#include "addons/programme/active_set_programme.hpp"
#include "addons/programme/dense_programme.hpp"
#include "bench/measure.hpp"
#include "bench/peers/peer.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/triangular.hpp"

namespace signorini::bench {
namespace {

Run directly(const Solver& solver, const DenseProgramme& programme, int calls) {
  Run run;
  run.seconds = mean_seconds(calls, [&] { (void)on_programmes(solver)(programme, {}); });
  DenseSolution solution = on_programmes(solver)(programme, {});
  run.iterations = solution.report.iterations;
  run.solution = std::move(solution.refined);
  if (solution.report.status != SolveStatus::Solved)
    run.failure = to_string(solution.report.status);
  return run;
}

Run condensed(const Solver& solver, const DenseProgramme& programme, int calls) {
  return by_condensation(programme, calls, [&](ContactProblem problem, Run& run) {
    ContactState state = solver.solve(problem, {});
    run.iterations = state.report.iterations;
    if (state.report.status != SolveStatus::Solved) run.failure = to_string(state.report.status);
    return std::move(state.force);
  });
}

}  // namespace

double mean_seconds(int calls, const std::function<void()>& call) {
  const double begin = processor_seconds();
  for (int i = 0; i < calls; ++i) call();
  return (processor_seconds() - begin) / calls;
}

Run by_condensation(const DenseProgramme& programme, int calls,
                    const std::function<Eigen::VectorXd(ContactProblem problem, Run& run)>& whole) {
  Run run;
  run.condensation = mean_seconds(calls, [&] { static_cast<void>(condense(programme)); });
  run.seconds = mean_seconds(calls, [&] {
    const DenseCondensed small = condense(programme);
    run.solution.force = whole(small.problem, run);
    Eigen::VectorXd pushed = small.half * run.solution.force;
    solve_lower_transposed(small.factor.lower(), pushed);
    run.solution.displacement = small.free_displacement - pushed;
  });
  return run;
}

std::vector<Peer> own_solvers() {
  std::vector<Peer> peers;
  for (const char* name : {"quasi_active_set", "primal_dual_active_set", "lemke"})
    for (const Solver& solver : solvers())
      if (solver.name == std::string(name))
        peers.push_back({name, "", [&solver](const DenseProgramme& programme, int calls) {
                           return on_programmes(solver) != nullptr
                                      ? directly(solver, programme, calls)
                                      : condensed(solver, programme, calls);
                         }});
  return peers;
}

}  // namespace signorini::bench

#include "signorini/solvers/friction_active_set.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "signorini/solvers/friction_lemke.hpp"
#include "signorini/solvers/friction_newton.hpp"
#include "signorini/solvers/friction_proofs.hpp"

namespace signorini {

using Eigen::Index;
using Eigen::VectorXd;

void exchange_motions(const ScaledFriction& problem, Index limit, FrictionPoint& point) {
  const double reach = friction_reach(problem);
  std::vector<std::vector<Motion>> seen;
  Report& report = point.report;
  report.status = Status::IterationLimit;
  for (Index step = 0; step < limit; ++step) {
    if (std::find(seen.begin(), seen.end(), point.motions) != seen.end()) {
      point.reason = "the motions run in circles";
      return;
    }
    seen.push_back(point.motions);
    ++report.factorisations;
    ++report.iterations;
    point.closure =
        close_friction(problem, point.motions, point.closure.force, point.closure.amplitude);
    if (point.closure.confirmed) {
      report.history.push_back(friction_iteration(problem, point, 0, 0));
      return;
    }
    if (!point.closure.force.allFinite() || !point.closure.movement.allFinite()) {
      report.status = Status::Breakdown;
      point.reason = "the equations of the motions are singular";
      return;
    }
    std::vector<Motion> next = point.motions;
    const Index changes =
        predict_motions(problem, point.closure.force, point.closure.movement, reach, next);
    report.history.push_back(friction_iteration(problem, point, changes, 0));
    point.motions = std::move(next);
  }
  point.reason = "the motions did not settle";
}

FrictionState friction_active_set(const FrictionProblem& problem, const SolverOptions& options) {
  const ScaledFriction scaled = equilibrate(problem);
  if (VectorXd way = escape(scaled); way.size() > 0)
    return escaping(problem, scaled, std::move(way));
  const bool limited = options.iteration_limit > 0;
  FrictionPoint point = friction_start(scaled);
  exchange_motions(scaled, limited ? options.iteration_limit : exchange_limit, point);
  if (!point.closure.confirmed && !limited) {
    FrictionPoint again = friction_start(scaled);
    again.report = std::move(point.report);
    point = std::move(again);
    follow_newton(scaled, point.report.iterations + newton_limit, point);
  }
  if (!point.closure.confirmed && !limited) follow_lemke(scaled, {}, point);
  return finished_state(problem, scaled, std::move(point));
}

}  // namespace signorini

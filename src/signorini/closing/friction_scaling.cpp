#include <algorithm>
#include <limits>
#include <utility>

#include "signorini/closing/bordered_system.hpp"
#include "signorini/closing/friction_closure.hpp"

namespace signorini {

using Eigen::Index;
using Eigen::VectorXd;

ScaledFriction equilibrate(const FrictionProblem& problem) {
  check_problem(problem);
  const Index n = problem.free_gap.size();
  FloatingProblem rows{{problem.compliance, VectorXd(2 * n)}, problem.rigid, problem.resultant};
  rows.contact.free_gap << problem.free_gap, problem.free_slip;
  if (problem.resultant.size() == 0) rows.rigid.resize(2 * n, 0);
  const ScaledFloating floating = equilibrate(rows);
  ScaledFriction scaled;
  scaled.compliance = floating.contact.compliance;
  scaled.free = floating.contact.free_gap;
  scaled.scale = floating.contact.scale;
  scaled.coefficient =
      problem.coefficient.cwiseProduct(scaled.scale.head(n)).cwiseQuotient(scaled.scale.tail(n));
  scaled.cohesion = problem.cohesion.cwiseQuotient(scaled.scale.tail(n));
  scaled.rigid = floating.span;
  scaled.resultant = floating.inverse.transpose() * floating.resultant;
  scaled.inverse = floating.amplitude_scale.asDiagonal() * floating.inverse;
  const VectorXd left =
      floating.resultant - floating.rigid.transpose() * (scaled.rigid * scaled.resultant);
  const double rounding = static_cast<double>(problem.rigid.size() + 1) *
                          std::numeric_limits<double>::epsilon() *
                          std::max(1.0, floating.inverse.norm());
  if (left.norm() > rounding * floating.resultant.norm())
    scaled.loose = -floating.amplitude_scale.cwiseProduct(left);
  return scaled;
}

FrictionState unscaled(const FrictionProblem& problem, const ScaledFriction& scaled,
                       const FrictionClosure& closure, const std::vector<Motion>& motions,
                       Report report, std::string reason) {
  const Index n = problem.free_gap.size();
  const VectorXd force = scaled.scale.cwiseProduct(closure.force);
  const VectorXd movement = closure.movement.cwiseQuotient(scaled.scale);
  FrictionState state;
  state.force = force.head(n);
  state.friction = force.tail(n);
  state.gap = movement.head(n);
  state.slip = movement.tail(n);
  state.amplitude = scaled.inverse * closure.amplitude;
  for (const Motion motion : motions)
    state.status.push_back(motion == Motion::Open    ? PairStatus::Open
                           : motion == Motion::Stick ? PairStatus::Stick
                                                     : PairStatus::Slip);
  state.report = std::move(report);
  state.reason = std::move(reason);
  if (state.report.status == Status::Solved && !certify(problem, state).holds()) {
    state.report.status = Status::Breakdown;
    state.reason = "the end of the method does not hold in the units of the problem";
  }
  return state;
}

}  // namespace signorini

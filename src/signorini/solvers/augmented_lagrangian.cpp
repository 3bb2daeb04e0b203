#include "signorini/solvers/augmented_lagrangian.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "signorini/core/rounding.hpp"
#include "signorini/problem/active_set_system.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Index most_passes = 100;

/// The amplitude at which the body first meets an obstacle on the way that its load pushes it.
VectorXd first_touch(const ScaledProblem& problem) {
  const VectorXd way = -problem.resultant;
  const VectorXd closing = -problem.rigid * way;
  double far = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < closing.size(); ++i)
    if (closing(i) > epsilon * largest(closing)) far = std::min(far, problem.free(i) / closing(i));
  return far < std::numeric_limits<double>::infinity() ? VectorXd(far * way)
                                                       : VectorXd::Zero(way.size());
}

/// Closed pairs, the largest force first.
std::vector<Index> by_force(const ContactState& state) {
  std::vector<Index> pairs = state.active;
  std::stable_sort(pairs.begin(), pairs.end(),
                   [&](Index i, Index j) { return state.force(i) > state.force(j); });
  return pairs;
}

/// The problem in which springs hold the modes.
ContactProblem with_penalty(const ScaledProblem& problem, const VectorXd& amplitude, double rho) {
  const auto& U = problem.rigid;
  ContactProblem held{problem.compliance, problem.free};
  held.compliance.noalias() += rho * U * U.transpose();
  held.free_gap += U * (amplitude - rho * problem.resultant);
  return held;
}

}  // namespace

ContactState augmented_lagrangian(const ContactProblem& problem, const HeldSolver& solve_held) {
  const ScaledProblem scaled = equilibrate(problem);
  const Index pairs = scaled.pairs();
  Report report;
  ActiveSetSolution last;
  last.amplitude = first_touch(scaled);
  last.force.setZero(pairs);
  ContactState now;
  const double trace = scaled.compliance.trace();
  double rho = trace > 0 ? trace : 1;
  double last_spring = std::numeric_limits<double>::infinity();
  for (Index passes = 0; passes < most_passes; ++passes) {
    now = solve_held(with_penalty(scaled, last.amplitude, rho));
    append(report, now.report);
    const VectorXd spring = scaled.rigid.transpose() * now.force - scaled.resultant;
    last.amplitude += rho * spring;
    ++report.factorisations;
    if (auto end = confirmed(scaled, by_force(now), &last)) {
      Report solved = report;
      solved.status = SolveStatus::Solved;
      ContactState state = finished(problem, scaled, end->first, end->second, std::move(solved));
      if (state.report.status == SolveStatus::Solved) return state;
    }
    if (report.status != SolveStatus::Solved) break;
    report.status = SolveStatus::IterationLimit;
    if (spring.norm() > 0.5 * last_spring) rho *= 2;
    last_spring = spring.norm();
  }
  if (report.status == SolveStatus::Feasible)
    report.status = SolveStatus::Breakdown;  // springs carry a part
  last.force = now.force;
  last.movement = now.gap;
  VectorXd proof;
  if (now.farkas_certificate.size() > 0) proof = scaled.scale.cwiseProduct(now.farkas_certificate);
  return finished(problem, scaled, last, statuses_of(now.active, pairs), std::move(report),
                  std::move(proof));
}

}  // namespace signorini

#include "signorini/solvers/springs.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "signorini/closing/balanced_pairs.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/report_sum.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index most_passes = 100;

/// Weights >= 0 with which the rows of U come closest to t, by the active set method of Lawson and
/// Hanson [\ref LawsonHanson1995].
VectorXd nonnegative_weights(const MatrixXd& U, const VectorXd& t) {
  VectorXd weight = VectorXd::Zero(U.rows());
  std::vector<Index> used;
  const double rounding = static_cast<double>(U.rows() + U.cols()) * epsilon * t.norm();
  while (true) {
    const VectorXd missing = t - U.transpose() * weight;
    VectorXd gain = U * missing;
    for (const Index i : used) gain(i) = 0;
    Index next = 0;
    if (gain.size() == 0 || gain.maxCoeff(&next) <= rounding) return weight;
    const VectorXd before = weight;
    used.push_back(next);
    while (true) {  // least squares over the rows in use; rows whose weight would pass zero leave
      const VectorXd best = least_norm_solution(U(used, Eigen::all).transpose(), t);
      double part = 1;
      for (std::size_t k = 0; k < used.size(); ++k)
        if (const double now = weight(used[k]), end = best(static_cast<Index>(k)); end <= 0)
          part = std::min(part, now / (now - end));
      for (std::size_t k = 0; k < used.size(); ++k)
        weight(used[k]) += part * (best(static_cast<Index>(k)) - weight(used[k]));
      const auto leaves = [&](Index i) { return part < 1 && weight(i) <= rounding; };
      const auto first =
          std::stable_partition(used.begin(), used.end(), [&](Index i) { return !leaves(i); });
      for (auto i = first; i != used.end(); ++i) weight(*i) = 0;
      const bool done = first == used.end();
      used.erase(first, used.end());
      if (done || used.empty()) break;
    }
    if ((t - U.transpose() * weight).norm() >= missing.norm())
      return before;  // only rounding moved
  }
}

/// A direction, scaled, in which the load pulls the body away, or an empty vector.
VectorXd escape(const ScaledFloating& problem) {
  const VectorXd& r = problem.resultant;
  const VectorXd t = problem.inverse.transpose() * r;
  const double rounding = static_cast<double>(problem.rigid.size() + 1) * epsilon *
                          std::max(1.0, problem.inverse.norm());
  // A part of the load along a motion that moves no pair.
  const VectorXd free = r - problem.rigid.transpose() * (problem.span * t);
  if (free.norm() > rounding * r.norm()) return -free;
  const VectorXd missing = problem.span.transpose() * nonnegative_weights(problem.span, t) - t;
  return missing.norm() > rounding * t.norm() ? VectorXd(problem.inverse * missing) : VectorXd();
}

/// The amplitude at which the body first meets an obstacle on the way that its load pushes it.
VectorXd first_touch(const ScaledFloating& problem) {
  const VectorXd way = -problem.inverse * (problem.inverse.transpose() * problem.resultant);
  const VectorXd closing = -problem.rigid * way;
  double far = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < closing.size(); ++i)
    if (closing(i) > epsilon * largest(closing))
      far = std::min(far, problem.contact.free_gap(i) / closing(i));
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
ContactProblem on_springs(const ScaledFloating& problem, const VectorXd& amplitude, double rho) {
  ContactProblem held{problem.contact.compliance, problem.contact.free_gap};
  held.compliance.noalias() += rho * problem.span * problem.span.transpose();
  held.free_gap += problem.rigid * amplitude -
                   rho * problem.span * (problem.inverse.transpose() * problem.resultant);
  return held;
}

/// The method of multipliers, after what was tried before it.
FloatingState solve_on_springs(const FloatingProblem& problem, const ScaledFloating& scaled,
                               const Solver& solver, const SolverOptions& options, Report report) {
  VectorXd amplitude = first_touch(scaled);
  ContactState now;
  Index passes = 0;
  double rho = spring_compliance(scaled);
  double last_spring = std::numeric_limits<double>::infinity();
  while (passes < most_passes) {
    now = solver.solve(on_springs(scaled, amplitude, rho), options);
    ++passes;
    append(report, now.report);
    const VectorXd missing = scaled.rigid.transpose() * now.force - scaled.resultant;
    const VectorXd spring = scaled.inverse.transpose() * missing;
    amplitude += rho * (scaled.inverse * spring);
    ++report.factorisations;
    const BalancedPairs end = balance_pairs(scaled, by_force(now), amplitude);
    if (auto solved = certified(problem, scaled, end, report)) {
      solved->passes = passes;
      return *solved;
    }
    if (report.status != Status::Solved) break;
    report.status = Status::IterationLimit;
    if (spring.norm() > 0.5 * last_spring) rho *= 2;
    last_spring = spring.norm();
  }
  if (report.status == Status::Infeasible && now.infeasibility.size() == 0)
    report.status = Status::Breakdown;  // said of a body on springs, and not proved
  FloatingState state = unscaled(scaled, {now.force, now.gap, {}, {}, false}, now.active, amplitude,
                                 std::move(report));
  if (now.infeasibility.size() > 0)
    state.contact.infeasibility = scaled.contact.scale.cwiseProduct(now.infeasibility);
  state.passes = passes;
  return state;
}

}  // namespace

FloatingState solve(const FloatingProblem& problem, const Solver& solver,
                    const SolverOptions& options) {
  const ScaledFloating scaled = equilibrate(problem);
  const Index n = scaled.contact.free_gap.size();
  FloatingState state;
  if (const VectorXd direction = escape(scaled); direction.size() > 0) {
    state.contact.report.status = Status::Infeasible;
    state = unscaled(scaled, {VectorXd::Zero(n), scaled.contact.free_gap, {}, {}, false}, {},
                     first_touch(scaled), std::move(state.contact.report));
    state.escape = scaled.amplitude_scale.cwiseProduct(direction);
    return state;
  }
  if (solver.solve_floating != nullptr) {
    state = solver.solve_floating(problem, options);
    if (state.contact.report.status == Status::Solved) return state;
  }
  return solve_on_springs(problem, scaled, solver, options, std::move(state.contact.report));
}

}  // namespace signorini

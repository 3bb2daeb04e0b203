#include "signorini/complementarity/floating.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "signorini/complementarity/bordered_system.hpp"
#include "signorini/core/exact_sum.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr Index most_passes = 100;

double largest(const VectorXd& v) { return v.size() == 0 ? 0 : v.cwiseAbs().maxCoeff(); }

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
      const VectorXd best =
          MatrixXd(U(used, Eigen::all).transpose()).completeOrthogonalDecomposition().solve(t);
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

/// Forces, gaps and amplitude when pairs are closed and the resultant is kept.
struct Balanced {
  ClosedPairs closed;
  VectorXd amplitude;
  std::vector<Index> active;
};

/// minus (start + A x + B y), row by row, summed in twice the working precision.
VectorXd residual(const VectorXd& start, const MatrixXd& A, const VectorXd& x, const MatrixXd& B,
                  const VectorXd& y) {
  VectorXd result(start.size());
  for (Index i = 0; i < start.size(); ++i) {
    ExactSum sum(-start(i));
    for (Index k = 0; k < x.size(); ++k) sum.add_product(-A(i, k), x(k));
    for (Index k = 0; k < y.size(); ++k) sum.add_product(-B(i, k), y(k));
    result(i) = sum.value();
  }
  return result;
}

/// Closes pairs exactly, with the amplitude near a given one, if that is a solution to rounding.
std::optional<Balanced> balanced(const ScaledFloating& problem,
                                 const std::vector<Index>& candidates, VectorXd amplitude) {
  const BorderedSystem system(problem, candidates);
  const std::vector<Index>& W = system.pairs();
  const MatrixXd G = problem.contact.compliance(W, W);
  const MatrixXd R = problem.rigid(W, Eigen::all);
  const MatrixXd Rt = R.transpose();
  const VectorXd d = problem.contact.free_gap(W);
  VectorXd force = VectorXd::Zero(d.size());
  for (int step = 0; step < 4; ++step) {
    const auto change = system.solve(residual(d, G, force, R, amplitude),
                                     residual(-problem.resultant, Rt, force, Rt, VectorXd()));
    force += change.first;
    amplitude += change.second;
  }
  const double rounding = static_cast<double>(W.size() + problem.resultant.size() + 1) * epsilon;
  const VectorXd pushed = residual(-problem.resultant, Rt, force, Rt, VectorXd()).cwiseAbs();
  const VectorXd terms = problem.resultant.cwiseAbs() + Rt.cwiseAbs() * force.cwiseAbs();
  if (!force.allFinite() || !amplitude.allFinite() ||
      (pushed.array() > 2 * rounding * terms.array()).any() ||
      (force.array() < -rounding * largest(force)).any())
    return std::nullopt;

  Balanced result;
  result.closed.force = VectorXd::Zero(problem.contact.free_gap.size());
  result.closed.force(W) = force.cwiseMax(0.0);
  const MatrixXd columns = problem.contact.compliance(Eigen::all, W);
  result.closed.gap = -residual(problem.contact.free_gap, columns, force, problem.rigid, amplitude);
  const VectorXd size = problem.contact.free_gap.cwiseAbs() +
                        columns.cwiseAbs() * force.cwiseAbs() +
                        problem.rigid.cwiseAbs() * amplitude.cwiseAbs();
  if ((result.closed.gap.array() < -2 * rounding * size.array()).any()) return std::nullopt;
  result.closed.gap(W).setZero();
  result.amplitude = std::move(amplitude);
  result.active = W;
  std::sort(result.active.begin(), result.active.end());
  return result;
}

/// Closed pairs, the largest force first.
std::vector<Index> by_force(const ContactState& state) {
  std::vector<Index> pairs = state.active;
  std::stable_sort(pairs.begin(), pairs.end(),
                   [&](Index i, Index j) { return state.force(i) > state.force(j); });
  return pairs;
}

void add_to(Report& report, Report& pass) {
  report.status = pass.status;
  report.iterations += pass.iterations;
  report.factorisations += pass.factorisations;
  report.history.insert(report.history.end(), pass.history.begin(), pass.history.end());
}

/// The problem in which springs hold the modes.
ContactProblem on_springs(const ScaledFloating& problem, const VectorXd& amplitude, double rho) {
  ContactProblem held{problem.contact.compliance, problem.contact.free_gap};
  held.compliance.noalias() += rho * problem.span * problem.span.transpose();
  held.free_gap += problem.rigid * amplitude -
                   rho * problem.span * (problem.inverse.transpose() * problem.resultant);
  return held;
}

/// The state in the units of the problem.
FloatingState unscaled(const ScaledFloating& problem, const ClosedPairs& closed,
                       std::vector<Index> active, const VectorXd& amplitude, FloatingState state) {
  state.contact =
      unscaled(problem.contact, closed, std::move(active), std::move(state.contact.report));
  state.amplitude = problem.amplitude_scale.cwiseProduct(amplitude);
  return state;
}

}  // namespace

FloatingState solve(const FloatingProblem& problem, const Solver& solver,
                    const SolverOptions& options) {
  const ScaledFloating scaled = equilibrate(problem);
  FloatingState state;
  VectorXd amplitude = first_touch(scaled);
  ContactState now{VectorXd::Zero(scaled.contact.free_gap.size()), scaled.contact.free_gap, {}, {}};
  Report& report = state.contact.report;
  if (const VectorXd direction = escape(scaled); direction.size() > 0)
    state.escape = scaled.amplitude_scale.cwiseProduct(direction);
  report.status = Status::Infeasible;
  double rho = spring_compliance(scaled);
  double last_spring = std::numeric_limits<double>::infinity();
  while (state.escape.size() == 0 && state.passes < most_passes) {
    now = solver.solve(on_springs(scaled, amplitude, rho), options);
    ++state.passes;
    add_to(report, now.report);
    const VectorXd missing = scaled.rigid.transpose() * now.force - scaled.resultant;
    const VectorXd spring = scaled.inverse.transpose() * missing;
    amplitude += rho * (scaled.inverse * spring);
    ++report.factorisations;
    if (auto end = balanced(scaled, by_force(now), amplitude)) {
      FloatingState solved = state;
      solved.contact.report.status = Status::Solved;
      solved = unscaled(scaled, end->closed, end->active, end->amplitude, std::move(solved));
      if (certify(problem, solved).holds()) return solved;
    }
    if (report.status != Status::Solved) break;
    report.status = Status::IterationLimit;
    if (spring.norm() > 0.5 * last_spring) rho *= 2;
    last_spring = spring.norm();
  }
  VectorXd proof = std::move(now.infeasibility);
  if (report.status == Status::Infeasible && proof.size() == 0 && state.escape.size() == 0)
    report.status = Status::Breakdown;  // said of a body on springs, and not proved
  if (proof.size() > 0) proof = scaled.contact.scale.cwiseProduct(proof);
  state = unscaled(scaled, {now.force, now.gap, {}, {}, false}, now.active, amplitude,
                   std::move(state));
  state.contact.infeasibility = proof;
  return state;
}

}  // namespace signorini

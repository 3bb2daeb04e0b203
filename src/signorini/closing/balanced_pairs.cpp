#include "signorini/closing/balanced_pairs.hpp"

#include <algorithm>
#include <utility>

#include "signorini/core/exact_sum.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

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

}  // namespace

BalancedPairs balance_pairs(const ScaledFloating& problem, const std::vector<Index>& candidates,
                            VectorXd amplitude) {
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
  const MatrixXd columns = problem.contact.compliance(Eigen::all, W);
  BalancedPairs result;
  ClosedPairs& closed = result.closed;
  closed.solvable = force.allFinite() && amplitude.allFinite() &&
                    (pushed.array() <= 2 * rounding * terms.array()).all();
  closed.force = VectorXd::Zero(problem.contact.free_gap.size());
  closed.force(W) = force;
  closed.force_rounding = VectorXd::Constant(closed.force.size(), rounding * largest(force));
  closed.gap = -residual(problem.contact.free_gap, columns, force, problem.rigid, amplitude);
  closed.gap_rounding =
      2 * rounding *
      VectorXd(problem.contact.free_gap.cwiseAbs() + columns.cwiseAbs() * force.cwiseAbs() +
               problem.rigid.cwiseAbs() * amplitude.cwiseAbs());
  result.amplitude = std::move(amplitude);
  result.active = W;
  std::sort(result.active.begin(), result.active.end());
  return result;
}

bool solves(const BalancedPairs& pairs) {
  const ClosedPairs& closed = pairs.closed;
  return closed.solvable && (closed.force.array() >= -closed.force_rounding.array()).all() &&
         (closed.gap.array() >= -closed.gap_rounding.array()).all();
}

std::vector<Index> next_set(const BalancedPairs& pairs) {
  const ClosedPairs& now = pairs.closed;
  std::vector<bool> closes(static_cast<std::size_t>(now.gap.size()));
  for (Index i = 0; i < now.gap.size(); ++i)
    closes[static_cast<std::size_t>(i)] = now.gap(i) < -now.gap_rounding(i);
  for (const Index i : pairs.active)
    closes[static_cast<std::size_t>(i)] = now.force(i) >= -now.force_rounding(i);
  std::vector<Index> next;
  for (std::size_t i = 0; i < closes.size(); ++i)
    if (closes[i]) next.push_back(static_cast<Index>(i));
  return next;
}

FloatingState unscaled(const ScaledFloating& problem, const ClosedPairs& closed,
                       std::vector<Index> active, const VectorXd& amplitude, Report report) {
  FloatingState state;
  state.contact = unscaled(problem.contact, closed, std::move(active), std::move(report));
  for (const Index i : state.contact.active)
    if (state.contact.report.status == Status::Solved) state.contact.gap(i) = 0;
  state.amplitude = problem.amplitude_scale.cwiseProduct(amplitude);
  return state;
}

std::optional<FloatingState> certified(const FloatingProblem& problem, const ScaledFloating& scaled,
                                       const BalancedPairs& pairs, Report report) {
  if (!solves(pairs)) return std::nullopt;
  report.status = Status::Solved;
  FloatingState state =
      unscaled(scaled, pairs.closed, pairs.active, pairs.amplitude, std::move(report));
  if (!certify(problem, state).holds()) return std::nullopt;
  return state;
}

}  // namespace signorini

#include "signorini/closing/closed_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "signorini/closing/refutation.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/exact_sum.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/certificate.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// -d_W - G_WW lambda_W, summed in twice the working precision.
Eigen::VectorXd residual(const Eigen::MatrixXd& G, const Eigen::VectorXd& d,
                         const Eigen::VectorXd& force) {
  std::vector<ExactSum> sum;
  sum.reserve(static_cast<std::size_t>(d.size()));
  for (Index i = 0; i < d.size(); ++i) sum.emplace_back(-d(i));
  for (Index j = 0; j < d.size(); ++j)  // column by column, as G is stored
    for (Index i = 0; i < d.size(); ++i)
      sum[static_cast<std::size_t>(i)].add_product(-G(i, j), force(j));
  Eigen::VectorXd r(d.size());
  for (Index i = 0; i < d.size(); ++i) r(i) = sum[static_cast<std::size_t>(i)].value();
  return r;
}

/// x = -G^-1 d with two steps of refinement.
/// \param factor  of G
template <typename Factor>
Eigen::VectorXd refined(const Factor& factor, const Eigen::MatrixXd& G, const Eigen::VectorXd& d) {
  Eigen::VectorXd force = factor.solve(-d);
  for (int step = 0; step < 2; ++step) force += factor.solve(residual(G, d, force));
  return force;
}

/// The forces that close a block, or nothing if it is singular to rounding.
Eigen::VectorXd block_forces(const Eigen::MatrixXd& G, const Eigen::VectorXd& d, bool symmetric) {
  const double rounding = static_cast<double>(d.size()) * std::numeric_limits<double>::epsilon();
  if (symmetric) {
    const CholeskyFactor factor(G);
    if (!factor.positive()) return {};
    // With unit diagonal a squared pivot of rounding size means that a row repeats the ones before it.
    const double smallest = factor.lower().diagonal().minCoeff();
    if (smallest * smallest <= rounding) return {};
    return refined(factor, G, d);
  }
  const LuFactor factor(G);
  const Eigen::VectorXd pivots = factor.pivots().cwiseAbs();
  if (pivots.minCoeff() <= rounding * pivots.maxCoeff()) return {};
  return refined(factor, G, d);
}

ScaledProblem scaled(const ContactProblem& problem) {
  const Eigen::VectorXd scale = pair_scales(problem.compliance);
  return {scale.asDiagonal() * problem.compliance * scale.asDiagonal(),
          scale.cwiseProduct(problem.free_gap), scale};
}

}  // namespace

ScaledProblem equilibrate(const ContactProblem& problem) {
  check_problem(problem);
  return scaled(problem);
}

ScaledProblem equilibrate_any(const ContactProblem& problem) {
  check_finite(problem);
  ScaledProblem result = scaled(problem);
  result.symmetric = is_symmetric(problem) && (problem.compliance.diagonal().array() >= 0).all();
  return result;
}

ClosedPairs close_pairs(const ScaledProblem& problem, const std::vector<Index>& active) {
  const Index n = problem.free_gap.size();
  ClosedPairs closed;
  closed.force.setZero(n);
  closed.force_rounding.setZero(n);
  closed.solvable = true;
  if (!active.empty()) {
    const Eigen::VectorXd force = block_forces(problem.compliance(active, active),
                                               problem.free_gap(active), problem.symmetric);
    if (force.size() == 0) {
      closed.solvable = false;
      return closed;
    }
    for (std::size_t k = 0; k < active.size(); ++k)
      closed.force(active[k]) = force(static_cast<Index>(k));
    closed.force_rounding.setConstant(static_cast<double>(active.size()) * epsilon *
                                      force.cwiseAbs().maxCoeff());
  }
  closed.gap = problem.free_gap;
  closed.gap_rounding = problem.free_gap.cwiseAbs();
  for (const Index j : active) {
    closed.gap += closed.force(j) * problem.compliance.col(j);
    closed.gap_rounding += std::abs(closed.force(j)) * problem.compliance.col(j).cwiseAbs();
  }
  closed.gap_rounding *= static_cast<double>(active.size() + 1) * epsilon;
  for (const Index j : active) closed.gap(j) = 0;
  return closed;
}

bool solves(const ScaledProblem& problem, const ClosedPairs& closed) {
  if (!closed.solvable || (closed.force.array() < -closed.force_rounding.array()).any() ||
      (closed.gap.array() < -closed.gap_rounding.array()).any())
    return false;
  const ContactState state{closed.force.cwiseMax(0.0), closed.gap.cwiseMax(0.0), {}, {}};
  // Its bound is 1e-12; in the units of the problem every force is rounded once more.
  return certify({problem.compliance, problem.free_gap}, state).holds(0.25e-12);
}

Eigen::VectorXd contradiction(const ScaledProblem& problem, const std::vector<Index>& active,
                              Index pair) {
  ScaledProblem pressed = problem;
  pressed.free_gap = problem.compliance.col(pair);
  const ClosedPairs held = close_pairs(pressed, active);
  if (!held.solvable) return {};
  Eigen::VectorXd y = held.force.cwiseMax(0.0);  // what is negative and no rounding shows in G y
  y(pair) = 1;
  y /= y.sum();
  if (!refutes(ContactProblem{problem.compliance, problem.free_gap}, y)) return {};
  return problem.scale.cwiseProduct(y);
}

std::vector<Index> independent_pairs(const ScaledProblem& problem,
                                     const std::vector<Index>& candidates) {
  // Row by row a Cholesky factor; a candidate whose squared pivot is of rounding size repeats the others.
  const double tiny =
      static_cast<double>(candidates.size() + 1) * std::numeric_limits<double>::epsilon();
  const Index n = static_cast<Index>(candidates.size());
  Eigen::MatrixXd L(n, n);
  std::vector<Index> chosen;
  for (const Index i : candidates) {
    const Index k = static_cast<Index>(chosen.size());
    Eigen::VectorXd row = problem.compliance(chosen, i);
    L.topLeftCorner(k, k).triangularView<Eigen::Lower>().solveInPlace(row);
    const double pivot = problem.compliance(i, i) - row.squaredNorm();
    if (pivot <= 2 * tiny) continue;
    L.row(k).head(k) = row.transpose();
    L(k, k) = std::sqrt(pivot);
    chosen.push_back(i);
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

std::optional<std::pair<ClosedPairs, std::vector<Index>>> confirmed(
    const ScaledProblem& problem, const std::vector<Index>& candidates) {
  std::vector<Index> chosen = candidates;
  if (problem.symmetric) chosen = independent_pairs(problem, candidates);
  std::sort(chosen.begin(), chosen.end());
  ClosedPairs closed = close_pairs(problem, chosen);
  if (!solves(problem, closed)) return std::nullopt;
  return std::make_pair(std::move(closed), std::move(chosen));
}

Index differences(std::vector<Index> one, std::vector<Index> other) {
  std::sort(one.begin(), one.end());
  std::sort(other.begin(), other.end());
  std::vector<Index> different;
  std::set_symmetric_difference(one.begin(), one.end(), other.begin(), other.end(),
                                std::back_inserter(different));
  return static_cast<Index>(different.size());
}

ContactState unscaled(const ScaledProblem& problem, const ClosedPairs& closed,
                      std::vector<Index> active, Report report) {
  ContactState state;
  state.force = problem.scale.cwiseProduct(closed.force);
  state.gap = closed.gap.cwiseQuotient(problem.scale);
  if (report.status == Status::Solved) {  // what is negative is of rounding size
    state.force = state.force.cwiseMax(0.0);
    state.gap = state.gap.cwiseMax(0.0);
  }
  state.active = std::move(active);
  state.report = std::move(report);
  return state;
}

ContactState certified(const ContactProblem& problem, ContactState state) {
  if (state.report.status == Status::Solved && !certify(problem, state).holds())
    state.report.status = Status::Breakdown;
  if (state.report.status == Status::Infeasible && !refutes(problem, state.infeasibility)) {
    state.report.status = Status::Breakdown;
    state.infeasibility.resize(0);
  }
  return state;
}

}  // namespace signorini

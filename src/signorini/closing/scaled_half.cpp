#include "signorini/closing/scaled_half.hpp"

#include <algorithm>
#include <cmath>

#include "signorini/closing/refutation.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/exact_sum.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// Columns of length 1 whose distance from the span of others is no more than this depend on them.
double dependent(Index rows, Index others) { return static_cast<double>(rows + others) * epsilon; }

/// -d - H^T (H lambda), summed in twice the working precision.
Eigen::VectorXd residual(const Eigen::MatrixXd& H, const Eigen::VectorXd& d,
                         const Eigen::VectorXd& force) {
  std::vector<ExactSum> sum(static_cast<std::size_t>(H.rows()));
  for (Index j = 0; j < H.cols(); ++j)
    for (Index i = 0; i < H.rows(); ++i)
      sum[static_cast<std::size_t>(i)].add_product(H(i, j), force(j));
  Eigen::VectorXd moved(H.rows());
  Eigen::VectorXd moved_low(H.rows());
  for (Index i = 0; i < H.rows(); ++i) {
    ExactSum& entry = sum[static_cast<std::size_t>(i)];
    moved(i) = entry.value();
    entry.add(-moved(i));
    moved_low(i) = entry.value();
  }
  Eigen::VectorXd r(d.size());
  for (Index j = 0; j < d.size(); ++j) {
    ExactSum entry(-d(j) - H.col(j).dot(moved_low));
    for (Index i = 0; i < H.rows(); ++i) entry.add_product(-H(i, j), moved(i));
    r(j) = entry.value();
  }
  return r;
}

/// The triangle R of H = Q R, or nothing if the columns depend on each other to rounding.
Eigen::MatrixXd triangle(const Eigen::MatrixXd& H) {
  const Index k = H.cols();
  if (k > H.rows()) return {};
  Eigen::MatrixXd R = qr_triangle(H);
  if (R.diagonal().cwiseAbs().minCoeff() <= dependent(H.rows(), k)) return {};
  return R;
}

/// x = -(H^T H)^-1 d by the triangle R, with two steps of refinement.
Eigen::VectorXd solved(const Eigen::MatrixXd& R, const Eigen::MatrixXd& H,
                       const Eigen::VectorXd& d) {
  const auto upper = R.triangularView<Eigen::Upper>();
  Eigen::VectorXd force = upper.solve(upper.transpose().solve(-d));
  for (int step = 0; step < 2; ++step)
    force += upper.solve(upper.transpose().solve(residual(H, d, force)));
  return force;
}

}  // namespace

ScaledHalf equilibrate(const HalfProblem& problem) {
  const Index n = problem.free_gap.size();
  require(problem.half.cols() == n, "contact problem: half must have ", n,
          " columns (one per pair), got ", problem.half.cols());
  require(problem.half.allFinite() && problem.free_gap.allFinite(),
          "contact problem: half and free_gap must be finite");
  ScaledHalf scaled;
  if (problem.half.rows() > n && n > 0) {
    scaled.half = qr_triangle(problem.half);
  } else {
    scaled.half = problem.half;
  }
  scaled.scale = scaled.half.colwise().norm().transpose().unaryExpr(
      [](double length) { return length > 0 ? 1 / length : 1; });
  scaled.half = scaled.half * scaled.scale.asDiagonal();
  scaled.free_gap = scaled.scale.cwiseProduct(problem.free_gap);
  return scaled;
}

ClosedPairs close_pairs(const ScaledHalf& problem, const std::vector<Index>& active) {
  const Index n = problem.free_gap.size();
  ClosedPairs closed;
  closed.force.setZero(n);
  closed.force_rounding.setZero(n);
  closed.solvable = true;
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(problem.half.rows());
  double pressed = 0;
  if (!active.empty()) {
    const Eigen::MatrixXd H = problem.half(Eigen::all, active);
    const Eigen::MatrixXd R = triangle(H);
    if (R.size() == 0) {
      closed.solvable = false;
      return closed;
    }
    const Eigen::VectorXd force = solved(R, H, problem.free_gap(active));
    for (std::size_t k = 0; k < active.size(); ++k)
      closed.force(active[k]) = force(static_cast<Index>(k));
    closed.force_rounding.setConstant(static_cast<double>(active.size()) * epsilon *
                                      force.cwiseAbs().maxCoeff());
    moved.noalias() = H * force;
    pressed = force.cwiseAbs().sum();
  }
  closed.gap = problem.free_gap;
  closed.gap.noalias() += problem.half.transpose() * moved;
  closed.gap_rounding = static_cast<double>(active.size() + 1) * epsilon *
                        (problem.free_gap.cwiseAbs().array() + pressed);
  for (const Index j : active) closed.gap(j) = 0;
  return closed;
}

bool solves(const ScaledHalf& problem, const ClosedPairs& closed) {
  if (!closed.solvable || (closed.force.array() < -closed.force_rounding.array()).any() ||
      (closed.gap.array() < -closed.gap_rounding.array()).any())
    return false;
  if (problem.free_gap.size() == 0) return true;
  // certify() measures gaps by the overlap without forces, or by what the forces move if that is more.
  // Each force, and with it each gap, is known no better than its rounding.
  const double length =
      std::max(-problem.free_gap.minCoeff(), (closed.gap - problem.free_gap).cwiseAbs().maxCoeff());
  return epsilon * closed.force.cwiseAbs().sum() <= 1e-12 * length || closed.force.isZero(0);
}

std::optional<std::pair<ClosedPairs, std::vector<Index>>> confirmed(
    const ScaledHalf& problem, const std::vector<Index>& candidates) {
  const Index rows = problem.half.rows();
  const Index most = std::min(rows, static_cast<Index>(candidates.size()));
  Eigen::MatrixXd Q(rows, most);
  std::vector<Index> chosen;
  for (const Index i : candidates) {
    const Index k = static_cast<Index>(chosen.size());
    if (k == most) break;
    Eigen::VectorXd rest = problem.half.col(i);
    for (int twice = 0; twice < 2; ++twice)  // once is not orthogonal to rounding
      rest -= Q.leftCols(k) * (Q.leftCols(k).transpose() * rest);
    const double length = rest.norm();
    if (length <= dependent(rows, most)) continue;
    Q.col(k) = rest / length;
    chosen.push_back(i);
  }
  std::sort(chosen.begin(), chosen.end());
  ClosedPairs closed = close_pairs(problem, chosen);
  if (!solves(problem, closed)) return std::nullopt;
  return std::make_pair(std::move(closed), std::move(chosen));
}

Eigen::VectorXd contradiction(const ScaledHalf& problem, const std::vector<Index>& active,
                              Index pair) {
  ScaledHalf pressed = problem;
  pressed.free_gap.noalias() = problem.half.transpose() * problem.half.col(pair);
  const ClosedPairs held = close_pairs(pressed, active);
  if (!held.solvable) return {};
  Eigen::VectorXd y = held.force.cwiseMax(0.0);  // what is negative and no rounding shows in H y
  y(pair) = 1;
  y /= y.sum();
  if (!refutes(HalfProblem{problem.half, problem.free_gap}, y)) return {};
  return problem.scale.cwiseProduct(y);
}

ContactState unscaled(const ScaledHalf& problem, const ClosedPairs& closed,
                      std::vector<Index> active, Report report) {
  return unscaled(ScaledProblem{{}, {}, problem.scale}, closed, std::move(active),
                  std::move(report));
}

}  // namespace signorini

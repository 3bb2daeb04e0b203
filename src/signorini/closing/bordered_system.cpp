#include "signorini/closing/bordered_system.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/triangular.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// U, V and the singular values of a matrix that are not rounding.
SingularValues factors_of(const MatrixXd& matrix) {
  if (matrix.size() == 0) return {MatrixXd(matrix.rows(), 0), {}, MatrixXd(matrix.cols(), 0)};
  const SingularValues all = singular_values(matrix);
  const double threshold = static_cast<double>(matrix.rows() + matrix.cols()) *
                           std::numeric_limits<double>::epsilon() * all.values(0);
  const Index rank = (all.values.array() > threshold).count();
  return {all.U.leftCols(rank), all.values.head(rank), all.V.leftCols(rank)};
}

}  // namespace

ScaledFloating equilibrate(const FloatingProblem& problem) {
  const Index n = problem.contact.free_gap.size();
  const Index modes = problem.resultant.size();
  require(problem.rigid.rows() == n && problem.rigid.cols() == modes,
          "floating problem: rigid must be ", n, " x ", modes,
          " (one row per pair, one column per entry of resultant), got ", problem.rigid.rows(),
          " x ", problem.rigid.cols());
  require(problem.rigid.allFinite() && problem.resultant.allFinite(),
          "floating problem: rigid and resultant must be finite");
  ScaledFloating scaled;
  scaled.contact = equilibrate(problem.contact);
  scaled.rigid = scaled.contact.scale.asDiagonal() * problem.rigid;
  scaled.amplitude_scale = VectorXd::Ones(modes);
  for (Index j = 0; j < modes; ++j)
    if (const double norm = scaled.rigid.col(j).norm(); norm > 0)
      scaled.amplitude_scale(j) = 1 / norm;
  scaled.rigid = scaled.rigid * scaled.amplitude_scale.asDiagonal();
  scaled.resultant = scaled.amplitude_scale.cwiseProduct(problem.resultant);
  const SingularValues factors = factors_of(scaled.rigid);
  scaled.span = factors.U;
  scaled.inverse = factors.V * factors.values.cwiseInverse().asDiagonal();
  return scaled;
}

double spring_compliance(const ScaledFloating& problem) {
  const double trace = problem.contact.compliance.trace();
  return trace > 0 ? trace : 1;
}

BorderedSystem::BorderedSystem(const ScaledFloating& problem,
                               const std::vector<Index>& candidates) {
  const double rho = spring_compliance(problem);
  const double tiny =
      2 * static_cast<double>(candidates.size() + 1) * std::numeric_limits<double>::epsilon();
  const MatrixXd span = problem.span(candidates, Eigen::all);
  MatrixXd block = problem.contact.compliance(candidates, candidates);
  block.noalias() += rho * span * span.transpose();
  const CholeskyFactor whole(block);
  if (whole.positive() &&
      (whole.lower().diagonal().array().square() > tiny * block.diagonal().array()).all()) {
    factor_ = whole.lower();
    pairs_ = candidates;
  } else {
    choose(block, candidates, tiny);
  }
  rigid_ = problem.rigid(pairs_, Eigen::all);
  spring_ = rho * problem.span(pairs_, Eigen::all) * problem.inverse.transpose();
  held_ = factors_of(rigid_).V;
  spread_ = rigid_ * held_;
  solve_lower_columns(factor_, spread_);
  schur_ = CholeskyFactor(spread_.transpose() * spread_);
  for (Index k = 0; k < spread_.cols(); ++k) solve_lower_transposed(factor_, spread_.col(k));
}

void BorderedSystem::choose(const MatrixXd& block, const std::vector<Index>& candidates,
                            double tiny) {
  factor_.setZero(block.rows(), block.rows());
  std::vector<Index> chosen;
  for (Index i = 0; i < block.rows(); ++i) {  // row by row a Cholesky factor
    const Index k = static_cast<Index>(chosen.size());
    VectorXd row = block(chosen, i);
    solve_lower(factor_.topLeftCorner(k, k), row);
    const double pivot = block(i, i) - row.squaredNorm();
    if (pivot <= tiny * block(i, i)) continue;
    factor_.row(k).head(k) = row.transpose();
    factor_(k, k) = std::sqrt(pivot);
    chosen.push_back(i);
    pairs_.push_back(candidates[static_cast<std::size_t>(i)]);
  }
  const Index closed = static_cast<Index>(chosen.size());
  factor_ = factor_.topLeftCorner(closed, closed).eval();
}

std::pair<VectorXd, VectorXd> BorderedSystem::solve(const VectorXd& top,
                                                    const VectorXd& bottom) const {
  const VectorXd load = top + spring_ * bottom;
  VectorXd amplitude = VectorXd::Zero(bottom.size());
  if (held_.cols() > 0)
    amplitude = held_ * schur_.solve(spread_.transpose() * load - held_.transpose() * bottom);
  VectorXd force = load - rigid_ * amplitude;
  solve_lower(factor_, force);
  solve_lower_transposed(factor_, force);
  return {force, amplitude};
}

}  // namespace signorini

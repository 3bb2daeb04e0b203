#include "signorini/complementarity/bordered_system.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// U, V and the singular values of a matrix that are not rounding.
struct Factors {
  MatrixXd U;
  MatrixXd V;
  VectorXd values;
};

Factors singular_values(const MatrixXd& matrix) {
  if (matrix.size() == 0) return {MatrixXd(matrix.rows(), 0), MatrixXd(matrix.cols(), 0), {}};
  Eigen::JacobiSVD<MatrixXd> svd(matrix, Eigen::ComputeThinU | Eigen::ComputeThinV);
  svd.setThreshold(static_cast<double>(matrix.rows() + matrix.cols()) *
                   std::numeric_limits<double>::epsilon());
  const Index rank = svd.rank();
  return {svd.matrixU().leftCols(rank), svd.matrixV().leftCols(rank),
          svd.singularValues().head(rank)};
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
  const Factors factors = singular_values(scaled.rigid);
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
  const Eigen::LLT<MatrixXd> whole(block);
  if (whole.info() == Eigen::Success &&
      (whole.matrixLLT().diagonal().array().square() > tiny * block.diagonal().array()).all()) {
    factor_ = whole.matrixL();
    pairs_ = candidates;
  } else {
    choose(block, candidates, tiny);
  }
  rigid_ = problem.rigid(pairs_, Eigen::all);
  spring_ = rho * problem.span(pairs_, Eigen::all) * problem.inverse.transpose();
  held_ = singular_values(rigid_).V;
  spread_ = rigid_ * held_;
  factor_.triangularView<Eigen::Lower>().solveInPlace(spread_);
  schur_.compute(spread_.transpose() * spread_);
  factor_.triangularView<Eigen::Lower>().transpose().solveInPlace(spread_);
}

void BorderedSystem::choose(const MatrixXd& block, const std::vector<Index>& candidates,
                            double tiny) {
  factor_.setZero(block.rows(), block.rows());
  std::vector<Index> chosen;
  for (Index i = 0; i < block.rows(); ++i) {  // row by row a Cholesky factor
    const Index k = static_cast<Index>(chosen.size());
    VectorXd row = block(chosen, i);
    factor_.topLeftCorner(k, k).triangularView<Eigen::Lower>().solveInPlace(row);
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
  factor_.triangularView<Eigen::Lower>().solveInPlace(force);
  factor_.triangularView<Eigen::Lower>().transpose().solveInPlace(force);
  return {force, amplitude};
}

}  // namespace signorini

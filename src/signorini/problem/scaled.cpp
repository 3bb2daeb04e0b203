#include "signorini/problem/scaled.hpp"

#include <algorithm>

#include "signorini/core/dense.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// F is kept by its entries, too, if at most one number in so many is not 0: that trades the speed of dense products
/// for their number. Solutions do not depend on it, as all are confirmed exactly on either.
constexpr Eigen::Index sparse_below = 64;

void scale_law(const FrictionLaw& law, ScaledProblem& scaled) {
  const Index slips = static_cast<Index>(law.pair.size());
  scaled.law = law;
  const VectorXd of_slips = scaled.scale.tail(slips);
  scaled.law.coefficient =
      law.coefficient.cwiseProduct(VectorXd(scaled.scale(law.pair))).cwiseQuotient(of_slips);
  scaled.law.cohesion = law.cohesion.cwiseQuotient(of_slips);
}

/// s R c = U inverse^-1 with columns c that make the length of each mode 1, and t from c r.
void scale_modes(const ContactProblem& problem, ScaledProblem& scaled) {
  const Index modes = problem.resultant.size();
  scaled.rigid.resize(scaled.free.size(), 0);
  scaled.inverse.resize(modes, 0);
  if (modes == 0) return;
  MatrixXd rigid = scaled.scale.asDiagonal() * problem.rigid;
  VectorXd unit = VectorXd::Ones(modes);
  for (Index j = 0; j < modes; ++j)
    if (const double norm = rigid.col(j).norm(); norm > 0) unit(j) = 1 / norm;
  rigid = rigid * unit.asDiagonal();
  const VectorXd resultant = unit.cwiseProduct(problem.resultant);
  Index rank = 0;
  MatrixXd inverse(modes, 0);
  if (rigid.rows() > 0) {
    const SingularValues all = singular_values(rigid);
    const double threshold =
        static_cast<double>(rigid.rows() + rigid.cols()) * epsilon * all.values(0);
    rank = (all.values.array() > threshold).count();
    scaled.rigid = all.U.leftCols(rank);
    // No amplitude, however large, may move what no mode moves.
    for (Index i = 0; i < rigid.rows(); ++i)
      if (rigid.row(i).isZero(0)) scaled.rigid.row(i).setZero();
    inverse = all.V.leftCols(rank) * all.values.head(rank).cwiseInverse().asDiagonal();
  }
  scaled.resultant = inverse.transpose() * resultant;
  scaled.inverse = unit.asDiagonal() * inverse;
  const VectorXd left = resultant - rigid.transpose() * (scaled.rigid * scaled.resultant);
  const double rounding =
      static_cast<double>(rigid.size() + 1) * epsilon * std::max(1.0, inverse.norm());
  if (left.norm() > rounding * resultant.norm())
    scaled.unconstrained_resultant = -unit.cwiseProduct(left);
}

ScaledProblem scaled_by_pairs(const ContactProblem& problem) {
  ScaledProblem scaled;
  const VectorXd free = free_movement(problem);
  scaled.scale = row_scales(problem.compliance, problem.rigid, free);
  scaled.compliance = scaled.scale.asDiagonal() * problem.compliance * scaled.scale.asDiagonal();
  scaled.free = scaled.scale.cwiseProduct(free);
  scale_law(problem.law, scaled);
  scale_modes(problem, scaled);
  if (!problem.law.pair.empty() &&
      sparse_below * (scaled.compliance.array() != 0).count() <= scaled.compliance.size())
    scaled.sparse = scaled.compliance.sparseView(0, 0);
  return scaled;
}

}  // namespace

ScaledProblem equilibrate(const ContactProblem& problem) {
  check_problem(problem);
  return scaled_by_pairs(problem);
}

ScaledProblem equilibrate_any(const ContactProblem& problem) {
  check_finite(problem);
  ScaledProblem scaled = scaled_by_pairs(problem);
  scaled.symmetric = is_symmetric(problem) && (problem.compliance.diagonal().array() >= 0).all();
  return scaled;
}

ContactProblem as_posed(const ScaledProblem& problem) {
  const Index pairs = problem.pairs();
  return {problem.compliance,
          problem.free.head(pairs),
          problem.free.tail(problem.free.size() - pairs),
          problem.law,
          problem.rigid,
          problem.resultant};
}

double force_scale(const MatrixXd& compliance) {
  const double sum = compliance.size() == 0 ? 0 : compliance.cwiseAbs().rowwise().sum().maxCoeff();
  return sum > 0 ? sum : 1;
}

double force_scale(const ScaledProblem& problem) {
  if (problem.sparse.size() == 0) return force_scale(problem.compliance);
  const double sum = (problem.sparse.cwiseAbs() * VectorXd::Ones(problem.free.size())).maxCoeff();
  return sum > 0 ? sum : 1;
}

}  // namespace signorini

// # One unit for all rows
//
// A thick plate and a thin wire may stand in one problem. Their compliances differ by many powers
// of ten, and "this force is small" then means nothing. So every solver works with a scaled
// problem. With \f$ s_i = 1/\sqrt{F_{ii}} \f$ it has
// \f[ \hat F_{ij} = s_i F_{ij} s_j, \qquad \hat d_i = s_i d_i, \qquad
// \lambda_i = s_i\hat\lambda_i. \f]
// This is the scaling of a symmetric matrix to unit diagonal, also called equilibration. A scaled
// force and a scaled gap have the same unit, the square root of an energy, so they can be compared.
//
// Two pairs, the first 400 times softer than the second:
// \f[ F = \begin{pmatrix} 4 & 0.1 \\ 0.1 & 0.01 \end{pmatrix}, \quad
// d = \begin{pmatrix} -2 \\ -0.1 \end{pmatrix}, \quad
// s = \begin{pmatrix} 1/2 \\ 10 \end{pmatrix}, \qquad
// \hat F = \begin{pmatrix} 1 & 0.5 \\ 0.5 & 1 \end{pmatrix}, \quad
// \hat d = \begin{pmatrix} -1 \\ -1 \end{pmatrix}. \f]
// The scaled pairs are alike. Both scaled forces are 2/3, and the forces are \f$ s_i \cdot 2/3 \f$,
// which is 1/3 and 20/3.

#include "signorini/problem/scaled.hpp"

#include <algorithm>

#include "signorini/core/dense.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

// Piles of rigid bodies that rub have an F that is mostly zeros. If at most one entry in 64 is not
// zero, F is also kept by its entries: only there sparse products make up for their slower
// arithmetic. The choice cannot change a solution, as the same conditions confirm each.
constexpr Eigen::Index sparse_below = 64;

// The bound \f$ |\tau_j| \le \mu\lambda_i + c \f$ joins two rows of different scales. Divided by
// \f$ s_j \f$ it says \f$ |\hat\tau_j| \le (\mu s_i/s_j)\,\hat\lambda_i + c/s_j \f$.
void scale_law(const FrictionLaw& law, ScaledProblem& scaled) {
  const Index slips = static_cast<Index>(law.pair.size());
  scaled.law = law;
  const VectorXd of_slips = scaled.scale.tail(slips);
  scaled.law.coefficient =
      law.coefficient.cwiseProduct(VectorXd(scaled.scale(law.pair))).cwiseQuotient(of_slips);
  scaled.law.cohesion = law.cohesion.cwiseQuotient(of_slips);
}

// Rigid modes may be given in any units and may depend on each other. A singular value
// decomposition \f$ U\Sigma V^T \f$ of the scaled modes, each of length 1, finds an orthonormal
// basis U of what they do to the rows. The balance \f$ R^T\lambda = r \f$ becomes
// \f$ U^T\hat\lambda = t \f$.
//
// Forces cannot balance the part of r that belongs to a motion that moves no row. If that part is
// more than rounding, the problem has no solution, and the part is kept as the proof.
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

// All the parts together. The scales of rows without a diagonal are those of row_scales().
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

// Most methods need a symmetric F. A matrix that is not symmetric enters by equilibrate_any(), and
// the scaled problem then says how it may be factored.
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

// A scaled problem is itself a problem. So checks that are written for problems serve for it too.
ContactProblem as_posed(const ScaledProblem& problem) {
  const Index pairs = problem.pairs();
  return {problem.compliance,
          problem.free.head(pairs),
          problem.free.tail(problem.free.size() - pairs),
          problem.law,
          problem.rigid,
          problem.resultant};
}

// In the example above the row sums of \f$ \hat F \f$ are 1.5: forces of size 1 on both pairs open
// each gap by 1.5. So a force counts 1.5 times as much as a gap.
double force_scale(const MatrixXd& compliance) {
  VectorXd sums = VectorXd::Zero(compliance.rows());
  for (Index column = 0; column < compliance.cols(); ++column)  // as they lie in memory
    sums += compliance.col(column).cwiseAbs();
  const double most = largest(sums);
  return most > 0 ? most : 1;
}

// P F P. Contact alone may hold a body. F then contains the springs that ground it, and these
// springs must not decide anything. Forces in balance do not strain them, and P leaves nothing
// else. If all bodies are rigid, nothing remains but rounding, which Newton's method would take for
// a compliance. So it becomes 0.
MatrixXd balanced_compliance(const ScaledProblem& problem) {
  const MatrixXd& U = problem.rigid;
  const MatrixXd& F = problem.compliance;
  if (U.cols() == 0) return F;
  MatrixXd projected = F - U * (U.transpose() * F);
  projected -= (projected * U).eval() * U.transpose();
  const double rounding = static_cast<double>(F.rows() + 1) * epsilon;
  if (force_scale(projected) <= rounding * force_scale(F))
    projected.setZero();  // only rigid motions
  return projected;
}

// Forces count as the gap that such forces on all pairs open. If no force strains anything, the
// grounded body at least has the right units.
double force_scale(const ScaledProblem& problem, const MatrixXd& compliance) {
  return force_scale(compliance.isZero(0) ? problem.compliance : compliance);
}

}  // namespace signorini

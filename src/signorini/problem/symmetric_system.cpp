// # The symmetric system of an active set
//
// Without sliding pairs the equations of a set are
//
// \f[ \begin{pmatrix} F_{WW} & U_W \\ U_W^T & 0 \end{pmatrix} \begin{pmatrix} f \\ b \end{pmatrix} =
//     \begin{pmatrix} h \\ t \end{pmatrix}. \f]
//
// The first block is symmetric and positive semidefinite, the whole is not: it is a saddle point. Since
// \f$ U_W^T f = t \f$ is given, \f$ \rho U_W U_W^T f = \rho U_W t \f$ may be added to the first equations. That
// is a spring on every mode, which changes no solution and makes the block positive definite. Then a Cholesky
// factor does for f, and a second, small one for b: the Schur complement \f$ U_W^T (\dots)^{-1} U_W \f$.
//
// Rows may repeat each other: two Gauss points on one edge of a rigid side close the same gap. Then as
// many rows are kept as are independent, the first of the set first. For the block (1 1; 1 1) that is the
// first row alone: the pivot of the second is \f$ 1 - 1^2 = 0 \f$. Least squares would share the force
// between both, and so find other forces in a problem whose forces are not the only ones.

#include <cmath>
#include <memory>
#include <utility>

#include "signorini/core/dense.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/active_set_system.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using Rows = std::vector<Index>;

// Positions of the rows of a block that are independent of those before them, by a Cholesky factor that
// grows row by row: a squared pivot of rounding size means that a row repeats others.
Rows independent_rows(const MatrixXd& block, double tiny) {
  MatrixXd L(block.rows(), block.rows());
  Rows chosen;
  for (Index i = 0; i < block.rows(); ++i) {
    const Index k = static_cast<Index>(chosen.size());
    VectorXd row = block(chosen, i);
    L.topLeftCorner(k, k).triangularView<Eigen::Lower>().solveInPlace(row);
    const double pivot = block(i, i) - row.squaredNorm();
    if (pivot <= tiny * block(i, i)) continue;
    L.row(k).head(k) = row.transpose();
    L(k, k) = std::sqrt(pivot);
    chosen.push_back(i);
  }
  return chosen;
}

// Orthonormal columns that span what the rows of a matrix span, to rounding.
MatrixXd row_space(const MatrixXd& matrix) {
  if (matrix.size() == 0) return MatrixXd(matrix.cols(), 0);
  const SingularValues all = singular_values(matrix);
  const double threshold =
      static_cast<double>(matrix.rows() + matrix.cols()) * epsilon * all.values(0);
  return all.V.leftCols((all.values.array() > threshold).count());
}

// The factors, and what is solved with them.
struct SymmetricFactors {
  CholeskyFactor block;  // of F_WW + rho U_W U_W^T
  MatrixXd rigid;        // U_W
  double rho = 0;        // compliance of the springs that hold the modes [-]
  MatrixXd held;         // `k x m` orthonormal: the modes that W holds
  MatrixXd spread;       // block^-1 U_W held
  CholeskyFactor schur;  // of held^T U_W^T spread

  // A mode that W leaves free gets no amplitude: nothing of the system depends on it.
  [[nodiscard]] std::pair<VectorXd, VectorXd> solve(const VectorXd& top,
                                                    const VectorXd& bottom) const {
    VectorXd amplitude = VectorXd::Zero(bottom.size());
    if (top.size() == 0) return {top, amplitude};
    if (bottom.size() == 0) return {block.solve(top), amplitude};
    VectorXd load = top + rho * (rigid * bottom);
    if (held.cols() > 0)
      amplitude = held * schur.solve(spread.transpose() * load - held.transpose() * bottom);
    load -= rigid * amplitude;
    return {block.solve(load), amplitude};
  }

  // The Schur complement of the modes, by half of a solve: its symmetric form needs \f$ L^{-1} U_W \f$ only.
  void factor_modes() {
    held = row_space(rigid);
    if (held.cols() == 0) return;
    MatrixXd half = rigid * held;
    solve_lower_columns(block.lower(), half);
    schur = CholeskyFactor(half.transpose() * half);
    spread = block.solve_columns(rigid * held);
  }
};

// A pivot is what a row adds to those before it: its squared distance from what they span.
// Whether a Cholesky factor has a pivot that is rounding of its diagonal entry.
bool repeats(const CholeskyFactor& factor, const MatrixXd& block, double tiny) {
  return !factor.positive() ||
         (factor.lower().diagonal().array().square() <= tiny * block.diagonal().array()).any();
}

}  // namespace

// The rows come in the order in which they are certain: where rows repeat each other the first ones stay.
// Most sets are independent, so they are factored at once. The choice row by row is slower, and is made
// only where a pivot is rounding.
ActiveSetSystem symmetric_system(const ScaledProblem& problem, const Rows& closed) {
  ActiveSetSystem system{closed};
  const auto factors = std::make_shared<SymmetricFactors>();
  const Index modes = problem.rigid.cols();
  // The trace is as large as the largest eigenvalue or larger: springs as stiff as the bodies.
  const double trace = problem.compliance.trace();
  factors->rho = modes > 0 ? (trace > 0 ? trace : 1) : 0;
  MatrixXd block = problem.compliance(closed, closed);
  if (modes > 0) {
    factors->rigid = problem.rigid(closed, Eigen::all);
    block.noalias() += factors->rho * factors->rigid * factors->rigid.transpose();
  }
  // Rounding of a row of the block grows with its length.
  const double tiny = 2 * static_cast<double>(closed.size() + 1) * epsilon;
  if (!closed.empty()) factors->block = CholeskyFactor(block);
  if (!closed.empty() && repeats(factors->block, block, tiny)) {
    // The factor of the rows that are kept is made anew, in one piece.
    const Rows chosen = independent_rows(block, tiny);
    const MatrixXd kept = block(chosen, chosen);
    factors->block = chosen.empty() ? CholeskyFactor() : CholeskyFactor(kept);
    system.rows.clear();
    for (const Index i : chosen) system.rows.push_back(closed[at(i)]);
    if (modes > 0) factors->rigid = problem.rigid(system.rows, Eigen::all);
  }
  // Only the rows that were kept hold the modes.
  if (modes > 0) factors->factor_modes();
  // The factors are shared by the copies of the function that solves with them.
  system.solve = [factors](const VectorXd& top, const VectorXd& bottom) {
    return factors->solve(top, bottom);
  };
  return system;
}

}  // namespace signorini

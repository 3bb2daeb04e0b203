// # The system of an active set with sliding pairs
//
// The friction force of a sliding pair follows its normal force, \f$ \tau = \mp(\mu\lambda + c) \f$. So the column
// of its normal force also has what the friction force moves, times the slope \f$ \mp\mu \f$. One pair
// with the compliance (2 1; 1 3) that slides forwards with \f$ \mu = 0.5 \f$ has the matrix
// \f$ 2 - 0.5 \cdot 1 = 1.5 \f$.
//
// Such a matrix is not symmetric, and with large friction it may be singular or have a determinant of the
// other sign. The first is met by a pseudo-inverse, which gives the least solution. The second is worth
// knowing: where the sign is not that of little friction, the problem has other solutions. It is read off
// the pivots of the LU factor, because the determinant itself may overflow.

#include <algorithm>
#include <memory>

#include "signorini/core/dense.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/active_set_system.hpp"

namespace signorini {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using Rows = std::vector<Index>;

// Open pairs have no row and no column.
// Rows are movements of W and resultants, columns the forces of W and amplitudes.
MatrixXd active_set_matrix(const ScaledProblem& problem, const Rows& rows, const ActiveSet& set) {
  const Index m = static_cast<Index>(rows.size());
  const Index k = problem.rigid.cols();
  MatrixXd M = MatrixXd::Zero(m + k, m + k);
  M.topLeftCorner(m, m) = problem.compliance(rows, rows);
  if (k > 0) {
    M.topRightCorner(m, k) = problem.rigid(rows, Eigen::all);
    M.bottomLeftCorner(k, m) = M.topRightCorner(m, k).transpose();
  }
  for (const SlidingPair& pair : set.sliding) {
    const Index column = std::find(rows.begin(), rows.end(), pair.gap) - rows.begin();
    M.col(column).head(m) += pair.slope * problem.compliance(rows, pair.slip);
    if (k > 0) M.col(column).tail(k) += pair.slope * problem.rigid.row(pair.slip).transpose();
  }
  return M;
}

// A system without rows and modes has nothing to solve: the function hands back what it got. The modes
// count in the sign, because each of them turns the sign of a saddle point.
ActiveSetSystem general_system(const ScaledProblem& problem, const ActiveSet& set) {
  ActiveSetSystem system{set.closed};
  const Index m = static_cast<Index>(set.closed.size());
  const Index k = problem.rigid.cols();
  system.solve = [](const VectorXd& top, const VectorXd& bottom) {
    return std::make_pair(top, bottom);
  };
  if (m + k == 0) return system;
  const MatrixXd M = active_set_matrix(problem, set.closed, set);
  // The reciprocal condition number says whether the factor has any right digit.
  const auto factor = std::make_shared<LuFactor>(M);
  const bool regular = factor->rcond() > static_cast<double>(m + k + 1) * epsilon;
  // An odd number of negative pivots, or of exchanged rows, turns the sign of the determinant.
  const bool odd = (factor->pivots().array() < 0).count() % 2 == 1;
  const bool negative = odd != (factor->permutation_sign() < 0);
  system.reversed = regular && negative != (k % 2 == 1);
  const auto inverse = std::make_shared<MatrixXd>(regular ? MatrixXd() : pseudo_inverse(M));
  // One vector goes in and comes out: forces first, then amplitudes.
  system.solve = [factor, inverse](const VectorXd& top, const VectorXd& bottom) {
    VectorXd right(top.size() + bottom.size());
    right << top, bottom;
    const VectorXd both = inverse->size() > 0 ? VectorXd(*inverse * right) : factor->solve(right);
    return std::make_pair(VectorXd(both.head(top.size())), VectorXd(both.tail(bottom.size())));
  };
  return system;
}

}  // namespace signorini

#include <limits>

#include "exercise.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/dense.hpp"

namespace ex4_1 {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Moved move_minimum(const MatrixXd& stiffness, const MatrixXd& A, const VectorXd& initial_gap,
                   const VectorXd& u) {
  Moved moved;
  moved.displacement = u;
  const VectorXd gap = initial_gap - A * u;
  const VectorXd rounding = 2 * static_cast<double>(u.size() + 1) *
                            std::numeric_limits<double>::epsilon() *
                            (initial_gap.cwiseAbs() + A.cwiseAbs() * u.cwiseAbs());
  for (Index i = 0; i < gap.size(); ++i)
    if (gap(i) < -rounding(i)) moved.violated.push_back(i);
  if (moved.violated.empty()) return moved;

  const signorini::CholeskyFactor K(stiffness);
  const MatrixXd rows = A(moved.violated, Eigen::all);
  MatrixXd half = rows.transpose();
  signorini::solve_lower_columns(K.lower(), half);
  const signorini::ContactProblem problem{half.transpose() * half, gap(moved.violated)};
  const VectorXd force = signorini::find_solver("surrogate_dual").solve(problem, {}).force;
  moved.total_force = force.sum();
  moved.weights = force / moved.total_force;
  moved.displacement -= K.solve(rows.transpose() * force);
  return moved;
}

}  // namespace ex4_1

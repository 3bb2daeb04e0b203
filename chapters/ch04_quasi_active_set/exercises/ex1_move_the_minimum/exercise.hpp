/// \file
/// Exercise 4.1 - move the minimum. Do not change this file.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace ex4_1 {

/// What one step of the outer loop finds.
struct Moved {
  std::vector<Eigen::Index> violated;  ///< rows with A u > g beyond rounding, in increasing order
  double total_force = 0;              ///< eta [force], 0 if no row is violated
  Eigen::VectorXd weights;             ///< xi, one per violated row in their order: >= 0, sum 1
  Eigen::VectorXd displacement;        ///< u^{k+1} `n` [length]; u^k if no row is violated
};

/// One step of the outer loop, \PaperEq{XuanLi2002, 36} to \PaperEq{XuanLi2002, 39}, with all violated rows.
///
/// u^{k+1} has the least energy 1/2 (u - u^k)^T K (u - u^k) of all u that satisfy the rows which u^k
/// violates; the others do not count. The problem is solved exactly, the rows are independent.
/// \param stiffness    K `n x n`, symmetric positive definite [force/length]
/// \param A            `n_c x n`: gap = initial_gap - A u [-]
/// \param initial_gap  g `n_c` [length]
/// \param u            u^k `n` [length], the minimum so far
[[nodiscard]] Moved move_minimum(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& A,
                                 const Eigen::VectorXd& initial_gap, const Eigen::VectorXd& u);

}  // namespace ex4_1

/// \file
/// Exercise 2.1 - the slope of the landscape. Do not change this file.
#pragma once
#include <Eigen/Core>

namespace ex2_1 {

/// The gradient of the surrogate dual, \PaperEq{XuanLi2002, 24}, with respect to the weights.
/// \param compliance  G `n_c x n_c`, symmetric positive definite [length/force]
/// \param free_gap    d `n_c` [length]: the gap without contact, overlap < 0
/// \param weights     xi `n_c` >= 0, not all zero; they need not sum to 1
/// \return gradient `n_c` [force*length]; zero where the weighted gap is open
[[nodiscard]] Eigen::VectorXd gradient(const Eigen::MatrixXd& compliance,
                                       const Eigen::VectorXd& free_gap,
                                       const Eigen::VectorXd& weights);

}  // namespace ex2_1

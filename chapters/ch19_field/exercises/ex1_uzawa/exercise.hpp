/// \file
/// Exercise 19.1 - Uzawa's loop. Do not change this file.
#pragma once
#include <Eigen/Core>

namespace ex19_1 {

/// Where the loop ended.
struct Ending {
  Eigen::VectorXd force;    ///< `n`, none negative [force]
  Eigen::Index passes = 0;  ///< how often gaps were computed
  bool ended = false;       ///< whether the accuracy was reached
};

/// Uzawa's method with the step \f$ 1 / \sum_j |G_{ij}| \f$ for pair i, from forces of zero.
///
/// With \f$ s_i = \sqrt{G_{ii}} \f$ it ends when the largest change \f$ s_i |\Delta\lambda_i| \f$ of a pass is at most
/// the accuracy times the largest \f$ \max(0, -d_i) / s_i \f$.
/// \param G         `n x n` compliance of the pairs, symmetric positive definite [length/force]
/// \param free_gap  `n` d, gaps without contact; open > 0 [length]
/// \param accuracy  positive [-]
/// \param most      passes, at least 1
/// \return the forces of the last pass; zero after one pass if nothing overlaps
[[nodiscard]] Ending uzawa(const Eigen::MatrixXd& G, const Eigen::VectorXd& free_gap,
                           double accuracy, Eigen::Index most);

}  // namespace ex19_1

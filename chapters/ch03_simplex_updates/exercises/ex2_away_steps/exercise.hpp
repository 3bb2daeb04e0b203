/// \file
/// Exercise 3.2 - away steps. Do not change this file.
#pragma once
#include <Eigen/Core>

namespace ex3_2 {

/// One iteration on the simplex of weights with away steps.
///
/// Of two pairs, the one that overlaps most under the forces eta xi and, among pairs with a positive
/// weight, the one that is most open, the larger fault is mended: towards the vertex of the first or
/// away from that of the second, by the step that makes s largest.
/// \param compliance  G `n_c x n_c`, symmetric positive definite [length/force]
/// \param free_gap    d `n_c` [length]: the gap without contact, overlap < 0
/// \param weights     xi `n_c` >= 0, sum 1, with a weighted overlap \f$ -d^T\xi > 0 \f$
/// \return the next weights, >= 0 with sum 1; a weight that an away step uses up is exactly 0
[[nodiscard]] Eigen::VectorXd away_step(const Eigen::MatrixXd& compliance,
                                        const Eigen::VectorXd& free_gap,
                                        const Eigen::VectorXd& weights);

}  // namespace ex3_2

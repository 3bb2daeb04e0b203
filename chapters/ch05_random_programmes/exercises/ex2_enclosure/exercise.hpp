/// \file
/// Exercise 5.2 - a programme made backwards, and bounds for its least energy. Do not change this file.
#pragma once
#include <Eigen/Core>

#include "signorini/problem/problem.hpp"

namespace ex5_2 {

/// Makes a programme whose solution is chosen beforehand: min u.K u / 2 - p.u with A u <= g.
/// \param K      `n x n`, symmetric positive definite
/// \param A      `m x n`
/// \param u      `n`, the solution
/// \param force  `m`, its forces >= 0
/// \param gap    `m`, its gaps >= 0, zero where there is a force
/// \return K, p, A, g
[[nodiscard]] signorini::DenseProgramme backwards(const Eigen::MatrixXd& K,
                                                  const Eigen::MatrixXd& A,
                                                  const Eigen::VectorXd& u,
                                                  const Eigen::VectorXd& force,
                                                  const Eigen::VectorXd& gap);

/// Two numbers that have the least energy f* between them.
struct Enclosure {
  double lower;
  double upper;
};

/// Encloses the least energy, given any u and any numbers in the place of forces.
///
/// Upper: the energy of u if no gap g - A u is below -1e-12 (|g_i| + |a_i| |u|), otherwise infinity.
/// Lower: the dual energy of the forces, the negative ones taken as zero,
/// \f[ -\tfrac12 (p - A^T\lambda)^T K^{-1} (p - A^T\lambda) - g^T\lambda. \f]
/// \param programme  K, p, A, g, without equations
/// \param u          `n`, any
/// \param force      `m`, any
/// \return the two bounds
[[nodiscard]] Enclosure enclose(const signorini::DenseProgramme& programme,
                                const Eigen::VectorXd& u, const Eigen::VectorXd& force);

}  // namespace ex5_2

/// \file
/// Exercise 9.2 - contact by penalty. Do not change this file.
#pragma once
#include <Eigen/Core>

#include "signorini/problem/problem.hpp"

namespace ex9_2 {

/// What springs in the place of contact come to.
struct Penalised {
  Eigen::VectorXd displacement;  ///< u `n` [length]
  Eigen::VectorXd force;         ///< lambda `n_c` [force], compression > 0
  double overlap = 0;            ///< largest of the negative gaps, as a positive number [length]
  double condition = 1;          ///< largest eigenvalue / smallest of K + k A_c^T A_c [-]
  bool settled = false;          ///< whether the springs stayed what they were
};

/// Solves K u + A^T lambda = p with lambda = k max(0, A u - g), row by row.
/// \param programme  K positive definite, p, A, g; gap = g - A u
/// \param k          stiffness of the springs > 0 [force/length]
/// \return forces, overlap and condition number of the last system; `settled` is false if 100 sets of
///   springs were not enough
[[nodiscard]] Penalised penalty(const signorini::DenseProgramme& programme, double k);

}  // namespace ex9_2

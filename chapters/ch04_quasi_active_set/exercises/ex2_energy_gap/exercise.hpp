/// \file
/// Exercise 4.2 - the last step and what it may lose. Do not change this file.
#pragma once
#include <Eigen/Core>

#include "signorini/problem/problem.hpp"

namespace ex4_2 {

/// Displacements and contact forces in balance: K u + A^T force = p, force >= 0.
struct Balanced {
  Eigen::VectorXd displacement;  ///< u `n`
  Eigen::VectorXd force;         ///< `n_c`, compression > 0
};

/// Where the last step ends.
struct End {
  double fraction = 0;  ///< delta, 1 if the target violates nothing
  Balanced state;       ///< u* and forces that balance it
  double energy = 0;    ///< potential energy of u*
  double energy_gap =
      0;  ///< the least energy is not below energy - energy_gap; exact for these forces
  bool optimal =
      false;  ///< whether the gap proves u* optimal: it is rounding, below 1e-12 (1 + |energy|)
};

/// The last step, \PaperEq{XuanLi2002, 34} and \PaperEq{XuanLi2002, 35}: as far from a feasible state
/// towards another one as no row is violated.
/// \param programme  K, p, A, g without equations, with numbers of the order of 1
/// \param from       balanced and feasible, A u <= g
/// \param towards    balanced, of less energy; may violate rows that are not tight in `from`
[[nodiscard]] End last_step(const signorini::DenseProgramme& programme, const Balanced& from,
                            const Balanced& towards);

}  // namespace ex4_2

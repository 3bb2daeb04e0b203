/// \file
/// Exercise 4.6 - keep the forces. Do not change this file.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/problem/problem.hpp"

namespace ex4_6 {

/// Where a round ends.
struct Round {
  Eigen::VectorXd displacement;  ///< u `n`
  Eigen::VectorXd force;         ///< lambda `m` >= 0, all that act: K u + A^T lambda = p
};

/// Rounds from the displacements without contact until no row is violated by more than 1e-12.
/// \param programme  K, p, A, g without equations, with numbers of the order of 1 and rows that do not contradict each other
/// \param most       rounds, at the most
/// \return every round; none if the displacements without contact violate nothing
[[nodiscard]] std::vector<Round> outer_loop(const signorini::DenseProgramme& programme, int most);

}  // namespace ex4_6

/// \file
/// Exercise 1.5 - stops that yield. Do not change this file.
#pragma once
#include <Eigen/Core>

#include "signorini/problem/problem.hpp"

namespace ex1_5 {

/// How a body rests on its stops.
struct Rest {
  Eigen::VectorXd force;  ///< lambda `n_c` [force] >= 0
  Eigen::VectorXd
      gap;  ///< `n_c` to where the stops were at first [length]; < 0: pushed back by so much
};

/// Contact with stops that yield.
/// \param problem  G, symmetric positive semidefinite, and d, without friction and rigid motions
/// \param yield    c `n_c` >= 0 [length/force]: how far a unit force pushes each stop back; 0 if it is rigid.
///                 Where stops depend on each other, c > 0
/// \return forces and gaps
/// \throws std::invalid_argument if `yield` has another size, or an entry that is negative or no number
[[nodiscard]] Rest come_to_rest(const signorini::ContactProblem& problem,
                                const Eigen::VectorXd& yield);

}  // namespace ex1_5

/// \file
/// Exercise 8.4 - through the inside. Do not change this file.
#pragma once
#include <Eigen/Core>

#include "signorini/problem/problem.hpp"

namespace ex8_4 {

/// A point of the path through the inside.
struct Inner {
  Eigen::VectorXd force;  ///< lambda `n_c` > 0 [force]
  Eigen::VectorXd gap;    ///< `n_c` > 0 [length]
};

/// The point with gap_i force_i = epsilon for every pair, and gap = d + G force.
/// \param problem  G `n_c x n_c` symmetric positive definite and d `n_c`; without friction and rigid modes
/// \param epsilon  the product [force length], > 0
/// \return forces and gaps; products right to 1e-10 of epsilon, gaps to 1e-12 of the largest number in the sums that they are
/// \throws std::invalid_argument if sizes do not fit or epsilon is not positive and finite
/// \throws signorini::NotSolved  if 200 steps are not enough
[[nodiscard]] Inner central(const signorini::ContactProblem& problem, double epsilon);

/// Contact forces, by the path to its end. \PaperEq{LinEtAl, 11}
/// \param problem  as for central()
/// \return lambda `n_c` >= 0 [force], 0 at open pairs, with closed gaps at all others
/// \throws std::invalid_argument if sizes do not fit
/// \throws signorini::NotSolved  as central()
[[nodiscard]] Eigen::VectorXd through_the_inside(const signorini::ContactProblem& problem);

}  // namespace ex8_4

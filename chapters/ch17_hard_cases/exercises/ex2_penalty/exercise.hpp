/// \file
/// Exercise 17.2 - a penalty without a unit. Do not change this file.
#pragma once
#include <Eigen/Core>

#include "signorini/problem/problem.hpp"

namespace ex17_2 {

/// Contact forces with a spring in each contact, found by trial and error.
/// \param problem    G `n x n` positive definite, and d `n`; without friction and rigid modes
/// \param stiffness  k > 0 of each spring [force/length]
/// \return `n` forces [force], none negative: of a pair with a force d + G lambda = -lambda / k, of all others it is >= 0
/// \throws signorini::NotSolved if a hundred sets of closed pairs do not suffice
[[nodiscard]] Eigen::VectorXd forces_of(const signorini::ContactProblem& problem, double stiffness);

/// Springs that are just stiff enough.
/// \param problem  as above
/// \param share    of the largest overlap without contact, in (0, 1) [-]
/// \return a stiffness, to a part in 1e9, at which the largest overlap is that share [force/length]; 0 if nothing overlaps
///   without contact
[[nodiscard]] double stiffness_for(const signorini::ContactProblem& problem, double share);

}  // namespace ex17_2

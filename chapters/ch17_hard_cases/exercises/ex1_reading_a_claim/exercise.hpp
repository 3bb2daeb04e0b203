/// \file
/// Exercise 17.1 - reading a claim. Do not change this file.
#pragma once
#include <Eigen/Core>

#include "signorini/problem/problem.hpp"

namespace ex17_1 {

/// What is wrong with a claim.
enum class Fault {
  None,       ///< nothing, to rounding
  Movement,   ///< the gaps are not those that the forces make, or a number is none
  Overlap,    ///< a gap is negative
  Tension,    ///< a force is negative
  AcrossAGap  ///< a pair has a gap and a force
};

/// Judges a claimed solution by the data alone.
/// \param problem  G `n x n` with positive diagonal entries, and d `n`; without friction and rigid modes
/// \param force    `n` lambda, claimed [force]
/// \param gap      `n` claimed [length]
/// \return the first fault in the order of the list that is larger than 1e-9 of what forces and gaps of the problem are measured
///   by; the same in all units, of all pairs or of each
[[nodiscard]] Fault fault_of(const signorini::ContactProblem& problem, const Eigen::VectorXd& force,
                             const Eigen::VectorXd& gap);

}  // namespace ex17_1

/// \file
/// Exercise 17.3 - proving that nothing fits. Do not change this file.
#pragma once
#include <Eigen/Core>

#include "signorini/problem/problem.hpp"

namespace ex17_3 {

/// Checks a proof that no forces leave all gaps open or closed: y >= 0, G y = 0, d.y < 0.
/// \param problem  G `n x n` symmetric positive semidefinite, and d `n`; without friction and rigid modes
/// \param y        `n` weights, any numbers
/// \return whether y proves it: no weight is negative, every entry of G y is at most 1e-12 of the sum of the sizes of its
///   terms, and d.y is below -1e-12 of that of its own
[[nodiscard]] bool proves(const signorini::ContactProblem& problem, const Eigen::VectorXd& y);

/// Looks for a proof by two rows that are opposite to each other.
/// \param problem  as above, with positive diagonal entries
/// \return weights with two entries above 0 that prove it, or nothing (size 0) if no two rows do
[[nodiscard]] Eigen::VectorXd find_proof(const signorini::ContactProblem& problem);

}  // namespace ex17_3

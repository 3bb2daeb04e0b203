/// \file
/// Exercise 3.4 - rows in any unit. Do not change this file.
#pragma once
#include <Eigen/Core>

#include "signorini/problem/problem.hpp"

namespace ex3_4 {

/// One step of the line search: the best part of the way to the vertex of the pair that overlaps most, where gaps count
/// over \f$ \sqrt{G_{ii}} \f$ and forces times \f$ \sqrt{G_{ii}} \f$.
/// \param problem  G, symmetric positive definite, and d, each row in a unit of its own
/// \param xi       weights `n_c` >= 0, sum 1, with a positive weighted overlap: shares of the forces
/// \return the next weights, >= 0, sum 1; the forces that they mean do not depend on the units of the rows
[[nodiscard]] Eigen::VectorXd update(const signorini::ContactProblem& problem,
                                     const Eigen::VectorXd& xi);

}  // namespace ex3_4

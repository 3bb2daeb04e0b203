/// \file
/// Exercise 6.4 - find the fault: three units. Do not change this file.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/problem/problem.hpp"

namespace ex6_4 {

using Rows = std::vector<Eigen::Index>;

/// The pairs with a force, by exchanging wrong pairs as in chapter 1.
/// \param problem  G, symmetric positive definite, and d, in any units, also of each row by itself
/// \return pairs whose force is more than what rounding makes of nothing, in increasing order; the same in all units
/// \throws std::runtime_error if a hundred sets are not enough
[[nodiscard]] Rows closed_nodes(const signorini::ContactProblem& problem);

}  // namespace ex6_4

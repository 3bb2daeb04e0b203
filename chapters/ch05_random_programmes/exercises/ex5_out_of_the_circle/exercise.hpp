/// \file
/// Exercise 5.5 - out of the circle. Do not change this file.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/problem/problem.hpp"

namespace ex5_5 {

using Rows = std::vector<Eigen::Index>;

/// The sets of closed pairs that the exchange looks at.
///
/// It begins with the pairs that overlap without contact. As long as no set comes back, all wrong pairs change sides at
/// once; from then on only the one with the lowest number.
/// \param problem  G symmetric positive definite and d, numbers of the order of 1; what is below 1e-12 is rounding
/// \param limit    on sets
/// \return all sets in the order in which they were looked at; the last one is the solution, unless there are `limit`
[[nodiscard]] std::vector<Rows> closed_pairs(const signorini::ContactProblem& problem,
                                             std::size_t limit);

}  // namespace ex5_5

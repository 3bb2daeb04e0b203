/// \file
/// Exercise 2.4 - one price for each group. Do not change this file.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/problem/problem.hpp"

namespace ex2_4 {

/// What groups of pairs are traded for.
struct Traded {
  Eigen::VectorXd total;  ///< eta `n_g` >= 0 [force] of each group
  Eigen::VectorXd
      force;          ///< lambda `n_c` [force]: the share of each pair of the total of its group
  double energy = 0;  ///< s, the dual energy of these forces [force*length]
};

/// The total forces of groups that are worth most together, for shares that are given.
/// \param problem  G, symmetric positive definite, and d
/// \param weight   `n_c` >= 0, in any scale: the share of a pair is its weight over those of its group
/// \param group    `n_c` number of the group of each pair, from 0 to the largest
/// \return totals, forces and energy
/// \throws std::invalid_argument if sizes differ, a weight or a number of a group is negative, or a group has no weight
[[nodiscard]] Traded trade_groups(const signorini::ContactProblem& problem,
                                  const Eigen::VectorXd& weight,
                                  const std::vector<Eigen::Index>& group);

}  // namespace ex2_4

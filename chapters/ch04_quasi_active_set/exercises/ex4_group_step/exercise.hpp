/// \file
/// Exercise 4.4 - a group step. Do not change this file.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/core/dense.hpp"
#include "signorini/problem/problem.hpp"

namespace ex4_4 {

using Rows = std::vector<Eigen::Index>;

/// Forces that close some pairs, of any sign; 0 elsewhere.
/// \param problem  G and d, its numbers of the order of 1
/// \param rows     pairs that do not depend on each other, in any order; none will do
/// \return lambda `n_c`
inline Eigen::VectorXd close(const signorini::ContactProblem& problem, const Rows& rows) {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(problem.free_gap.size());
  if (rows.empty()) return force;
  const signorini::CholeskyFactor factor(problem.compliance(rows, rows));
  force(rows) = factor.solve(-problem.free_gap(rows));
  return force;
}

/// Proposes a group.
///
/// First the pairs with a force, in increasing order; then those with a gap below -1e-10, the largest overlap first, each
/// unless it depends on those before: nothing, that is at most 1e-8 of its G_ii, is left of it when they are closed.
/// \param problem  as above
/// \param force    lambda `n_c` >= 0
/// \return the group
[[nodiscard]] Rows group_of(const signorini::ContactProblem& problem, const Eigen::VectorXd& force);

/// Where a round ends.
struct Round {
  Eigen::VectorXd force;  ///< lambda `n_c` >= 0, with more dual energy than before
  bool at_once = false;   ///< whether the bold way was good enough
};

/// Lets a group join.
///
/// At once: closes all of it, opens all pairs that pull together, closes the rest, and so on until none pulls. If the dual
/// energy has not risen, carefully: from the old forces towards those that close the group, as far as no force changes
/// its sign; what has arrived at zero and was to pull opens; then towards those that close the rest, and so on.
/// \param problem  as above
/// \param old      lambda `n_c` >= 0, closing just the pairs that have a force
/// \param group    from group_of(problem, old), with at least one pair more than those
/// \return forces >= 0 that close just the pairs that have one
[[nodiscard]] Round group_step(const signorini::ContactProblem& problem, const Eigen::VectorXd& old,
                               const Rows& group);

/// Rounds from no force at all, driven by your two functions, until nobody joins.
/// \param problem  as above
/// \param most     rounds
/// \return what each round made
inline std::vector<Round> drive(const signorini::ContactProblem& problem, int most) {
  std::vector<Round> rounds;
  Eigen::VectorXd force = Eigen::VectorXd::Zero(problem.free_gap.size());
  while (static_cast<int>(rounds.size()) < most) {
    const Rows group = group_of(problem, force);
    if (static_cast<Eigen::Index>(group.size()) <= (force.array() > 0).count()) break;
    rounds.push_back(group_step(problem, force, group));
    force = rounds.back().force;
  }
  return rounds;
}

}  // namespace ex4_4

/// \file
/// The one linear system that every active-set method solves: the forces that close given pairs.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/complementarity/problem.hpp"

namespace signorini {

/// A contact problem with pair i scaled by s_i = 1 / sqrt(G_ii): unit diagonal, one unit for all numbers.
///
/// A change of units, of the stiffness of a body or of the scale of one row leaves it as it is.
struct ScaledProblem {
  Eigen::MatrixXd compliance;  ///< s_i G_ij s_j [-]
  Eigen::VectorXd free_gap;    ///< s_i d_i [sqrt(energy)]
  Eigen::VectorXd scale;       ///< s_i; force = s * scaled force, gap = scaled gap / s
};

/// Equilibrates a problem; pairs with G_ii = 0 keep scale 1. \throws std::invalid_argument as check_problem()
[[nodiscard]] ScaledProblem equilibrate(const ContactProblem& problem);

/// Forces and gaps when exactly the pairs of `active` are closed.
struct ClosedPairs {
  Eigen::VectorXd force;           ///< `n_c`, 0 outside `active`; scaled
  Eigen::VectorXd gap;             ///< `n_c`, exactly 0 on `active`; scaled
  Eigen::VectorXd force_rounding;  ///< `n_c` what rounding may have done to each force
  Eigen::VectorXd gap_rounding;    ///< `n_c` and to each gap
  bool solvable = false;  ///< false if the block of `active` is singular to working precision
};

/// Solves G_WW lambda_W = -d_W with two steps of iterative refinement, then evaluates all gaps.
[[nodiscard]] ClosedPairs close_pairs(const ScaledProblem& problem,
                                      const std::vector<Eigen::Index>& active);

/// Turns scaled numbers into a state of the original problem.
[[nodiscard]] ContactState unscaled(const ScaledProblem& problem, const ClosedPairs& closed,
                                    std::vector<Eigen::Index> active, Report report);

}  // namespace signorini

/// \file
/// The one linear system that every active-set method solves: the forces that close given pairs.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "signorini/problem/problem.hpp"

namespace signorini {

/// A contact problem with pair i scaled by \f$ s_i = 1 / \sqrt{G_{ii}} \f$: unit diagonal, one unit
/// for all forces and gaps.
///
/// A change of units, of the stiffness of a body or of the scale of one row leaves it as it is.
struct ScaledProblem {
  Eigen::MatrixXd compliance;  ///< `n_c x n_c` s_i G_ij s_j [-]
  Eigen::VectorXd free_gap;    ///< `n_c` s_i d_i [sqrt(energy)]
  Eigen::VectorXd scale;       ///< `n_c` s_i; force = s * scaled force, gap = scaled gap / s
  bool symmetric = true;       ///< whether G may be factored as such: symmetric, no diagonal < 0
};

/// Equilibrates a problem.
/// \param problem  G and d
/// \return the scaled problem; a pair with G_ii = 0 keeps the scale 1
/// \throws std::invalid_argument as check_problem()
[[nodiscard]] ScaledProblem equilibrate(const ContactProblem& problem);

/// Equilibrates w = M z + q with any matrix by its pair_scales(): a contact problem as equilibrate().
/// \param problem  M and q
/// \return the scaled problem
/// \throws std::invalid_argument as check_finite()
[[nodiscard]] ScaledProblem equilibrate_any(const ContactProblem& problem);

/// Forces and gaps when exactly the pairs of a set are closed; scaled numbers [sqrt(energy)].
struct ClosedPairs {
  Eigen::VectorXd force;           ///< `n_c`, 0 outside of the set; tension < 0 is possible
  Eigen::VectorXd gap;             ///< `n_c`, exactly 0 in the set; overlap < 0 is possible
  Eigen::VectorXd force_rounding;  ///< `n_c`, what rounding may have done to each force
  Eigen::VectorXd gap_rounding;    ///< `n_c`, and to each gap
  bool solvable = false;           ///< false if the block of the set is singular to rounding
};

/// Solves \f$ G_{WW} \lambda_W = -d_W \f$ with two steps of refinement, then finds all gaps.
/// \param problem  scaled by equilibrate() or equilibrate_any()
/// \param active   W, without repetition
/// \return forces and gaps; if not `solvable`, forces are 0 and the gaps empty
[[nodiscard]] ClosedPairs close_pairs(const ScaledProblem& problem,
                                      const std::vector<Eigen::Index>& active);

/// Whether closed pairs are a solution: no force is tensile and no pair overlaps beyond rounding, and
/// rounding is so small that certify() agrees. It does not where a block passed as regular only because
/// of its rounding: then the forces are huge, and any gap could be rounding.
/// \param problem  scaled by equilibrate()
/// \param closed   from close_pairs() of it
/// \return whether a solver may say Solved
[[nodiscard]] bool solves(const ScaledProblem& problem, const ClosedPairs& closed);

/// Looks for the proof that nothing solves a problem: y with y_p = 1 and \f$ y_W = -G_{WW}^{-1} G_{Wp} \f$,
/// the forces that hold the pairs of a set where they are while one more is pressed.
/// \param problem  scaled by equilibrate()
/// \param active   W, without p
/// \param pair     p, which depends on W
/// \return y `n_c` in the units of the forces, such that the scaled ones sum to 1, if it refutes() the scaled
///   problem; otherwise an empty vector
[[nodiscard]] Eigen::VectorXd contradiction(const ScaledProblem& problem,
                                            const std::vector<Eigen::Index>& active,
                                            Eigen::Index pair);

/// Takes as many pairs as are independent, one after the other.
/// \param problem     scaled by equilibrate(), symmetric
/// \param candidates  pairs without repetition, the most wanted first
/// \return those that do not depend on the ones before them to rounding, in increasing order
[[nodiscard]] std::vector<Eigen::Index> independent_pairs(
    const ScaledProblem& problem, const std::vector<Eigen::Index>& candidates);

/// Ends a method that only guesses which pairs are closed: takes as many of them as are independent,
/// closes these exactly, and looks whether that is a solution.
/// \param problem     scaled; without symmetry all candidates are closed or nothing is returned
/// \param candidates  pairs taken as closed, the most certain first
/// \return forces and gaps if they are a solution, see solves(), with the pairs that were closed in
///   increasing order; otherwise nothing
[[nodiscard]] std::optional<std::pair<ClosedPairs, std::vector<Eigen::Index>>> confirmed(
    const ScaledProblem& problem, const std::vector<Eigen::Index>& candidates);

/// \param one    pairs without repetition, in any order
/// \param other  the same
/// \return how many pairs are in one of the two and not in the other
[[nodiscard]] Eigen::Index differences(std::vector<Eigen::Index> one,
                                       std::vector<Eigen::Index> other);

/// Turns scaled numbers into a state of the original problem.
/// \param problem  whose scales were used
/// \param closed   forces and gaps `n_c`; negative ones, which may be rounding, become 0
/// \param active   closed pairs, in increasing order
/// \param report   how the solver got there
/// \return the state
[[nodiscard]] ContactState unscaled(const ScaledProblem& problem, const ClosedPairs& closed,
                                    std::vector<Eigen::Index> active, Report report);

/// Withdraws a claim that the problem as it was posed does not confirm: scaling back is rounded, which
/// dependent pairs with large forces can notice.
/// \param problem  G and d as they were posed
/// \param state    as unscaled() gives it, with its proof if it claims `Infeasible`
/// \return the state, `Breakdown` instead of `Solved` if the certificate is worse than 1e-12, and instead of
///   `Infeasible`, without the proof, if that does not hold by refutes()
[[nodiscard]] ContactState certified(const ContactProblem& problem, ContactState state);

}  // namespace signorini

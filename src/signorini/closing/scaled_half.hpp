/// \file
/// Equilibrated contact problems whose compliance is left as a product G = H^T H.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "signorini/closing/closed_pairs.hpp"

namespace signorini {

/// A problem G = H^T H with every column of H scaled to length 1, as ScaledProblem for the product.
struct ScaledHalf {
  Eigen::MatrixXd half;      ///< `n x n_c` h_i s_i [-], s_i = 1 / |h_i|
  Eigen::VectorXd free_gap;  ///< `n_c` s_i d_i [sqrt(energy)]
  Eigen::VectorXd scale;     ///< `n_c` s_i; force = s * scaled force, gap = scaled gap / s
};

/// Equilibrates a problem. If H has more rows than columns, the triangle of its QR factors, which has
/// the same products, takes its place.
/// \param problem  H and d
/// \return the scaled problem; a column of zeros keeps the scale 1
/// \throws std::invalid_argument unless H has one column per pair and all numbers are finite
[[nodiscard]] ScaledHalf equilibrate(const HalfProblem& problem);

/// Forces and gaps when exactly the pairs of a set are closed, from a QR factorisation of their columns,
/// with two steps of refinement.
/// \param problem  scaled by equilibrate()
/// \param active   W, without repetition
/// \return forces and gaps; if not `solvable`, the columns depend on each other to rounding, forces are
///   0 and the gaps empty
[[nodiscard]] ClosedPairs close_pairs(const ScaledHalf& problem,
                                      const std::vector<Eigen::Index>& active);

/// Whether closed pairs are a solution, as for a ScaledProblem.
/// \param problem  scaled by equilibrate()
/// \param closed   from close_pairs() of it
/// \return whether no force is tensile and no pair overlaps beyond rounding, and rounding is small
[[nodiscard]] bool solves(const ScaledHalf& problem, const ClosedPairs& closed);

/// Ends a method that only guesses which pairs are closed, as for a ScaledProblem.
/// \param problem     scaled by equilibrate()
/// \param candidates  pairs taken as closed, the most certain first
/// \return forces and gaps if they are a solution, see solves(), with the pairs that were closed in
///   increasing order; otherwise nothing
[[nodiscard]] std::optional<std::pair<ClosedPairs, std::vector<Eigen::Index>>> confirmed(
    const ScaledHalf& problem, const std::vector<Eigen::Index>& candidates);

/// Looks for the proof that nothing solves a problem, as for a ScaledProblem.
/// \param problem  scaled by equilibrate()
/// \param active   W, without p
/// \param pair     p, which depends on W
/// \return y `n_c` in the units of the forces, or an empty vector
[[nodiscard]] Eigen::VectorXd contradiction(const ScaledHalf& problem,
                                            const std::vector<Eigen::Index>& active,
                                            Eigen::Index pair);

/// Turns scaled numbers into a state of the original problem.
/// \param problem  whose scales were used
/// \param closed   forces and gaps `n_c`; negative ones, which may be rounding, become 0
/// \param active   closed pairs, in increasing order
/// \param report   how the solver got there
/// \return the state
[[nodiscard]] ContactState unscaled(const ScaledHalf& problem, const ClosedPairs& closed,
                                    std::vector<Eigen::Index> active, Report report);

}  // namespace signorini

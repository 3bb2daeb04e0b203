/// \file
/// The exact end of every method for floating bodies: closed pairs whose forces balance the load.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "signorini/closing/bordered_system.hpp"

namespace signorini {

/// Forces, gaps and amplitudes when the pairs of a set are closed and the resultant is kept; scaled.
struct BalancedPairs {
  ClosedPairs closed;  ///< `solvable` if the numbers are finite and R^T lambda = r to rounding
  Eigen::VectorXd amplitude;         ///< `n_r`
  std::vector<Eigen::Index> active;  ///< the pairs that were closed, in increasing order
};

/// Closes pairs exactly, with four steps of refinement.
/// \param problem     scaled by equilibrate()
/// \param candidates  pairs to close, the most certain first; those that repeat others are left out
/// \param amplitude   where to start `n_r`: what the pairs do not hold stays there
/// \return forces, gaps and amplitude, of any sign
[[nodiscard]] BalancedPairs balance_pairs(const ScaledFloating& problem,
                                          const std::vector<Eigen::Index>& candidates,
                                          Eigen::VectorXd amplitude);

/// \param pairs  from balance_pairs()
/// \return whether no force is tensile and no pair overlaps beyond rounding
[[nodiscard]] bool solves(const BalancedPairs& pairs);

/// \param pairs  from balance_pairs()
/// \return the pairs that an active set method closes next, in increasing order: all but those in tension,
///   and those that overlap
[[nodiscard]] std::vector<Eigen::Index> next_set(const BalancedPairs& pairs);

/// Turns scaled numbers into a state of the original problem.
/// \param problem    whose scales were used
/// \param closed     forces and gaps `n_c`
/// \param active     closed pairs, in increasing order
/// \param amplitude  `n_r`
/// \param report     how the solver got there
/// \return the state
[[nodiscard]] FloatingState unscaled(const ScaledFloating& problem, const ClosedPairs& closed,
                                     std::vector<Eigen::Index> active,
                                     const Eigen::VectorXd& amplitude, Report report);

/// Claims closed pairs as the solution, if they are.
/// \param problem  as it was posed
/// \param scaled   by equilibrate()
/// \param pairs    from balance_pairs()
/// \param report   how the solver got there
/// \return the state, `Solved`, if solves() and its certificate agree; otherwise nothing
[[nodiscard]] std::optional<FloatingState> certified(const FloatingProblem& problem,
                                                     const ScaledFloating& scaled,
                                                     const BalancedPairs& pairs, Report report);

}  // namespace signorini

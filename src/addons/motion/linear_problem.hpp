// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The linearised contact problem of an iteration, and what is tried if its tangent has no factor.
#pragma once
#include <string>
#include <vector>

#include "addons/motion/corrected_solve.hpp"
#include "signorini/scene/solution.hpp"

namespace signorini {

/// The rows that hold: gaps of closed pairs, and slips of those of them that stick.
/// \param statuses  `n_c` what the pairs do
/// \param law       of the frictional pairs
/// \return rows of A, increasing
[[nodiscard]] std::vector<Eigen::Index> held_rows(const std::vector<ContactStatus>& statuses,
                                                  const FrictionLaw& law);

/// The rung of the ladder from which on springs hold every unknown, since no pair that presses makes the tangent definite.
inline constexpr std::size_t weak_springs = 3;

/// The linear problem of a model with a tangent of its own, which may be indefinite.
struct TangentProblem {
  Model& model;  ///< placed, with K and p of the iteration, which it keeps
  const std::vector<Eigen::Index>& held;  ///< rows that held last, see held_rows()
  const TurnedForces& turned;    ///< how contact forces turn
  const SolverOptions& options;  ///< for the solver
  std::size_t& rung;  ///< of the ladder, to begin with; becomes the one that held
};

/// \param problem    of an iteration
/// \param condensed  becomes that of K
/// \param ledger     goes on in the solution
/// \return the solution in the way d; if no K has a factor, Breakdown with the reason
[[nodiscard]] Solution solve_with_tangent(const TangentProblem& problem, Condensed& condensed,
                                          Ledger ledger);

/// \param model  placed
/// \param held   rows that held in its last iteration
/// \param rung   of the ladder, that held in its last iteration
/// \return what is wrong with that tangent: nothing holds a body, or it needed springs, where a body has lost its stability at which
///   strain; empty if nothing is
[[nodiscard]] std::string why_indefinite(const Model& model, const std::vector<Eigen::Index>& held,
                                         std::size_t rung);

/// \param model  placed
/// \return the side of a cell with a law that is shortened most, in words
[[nodiscard]] std::string most_shortened(const Model& model);

}  // namespace signorini

/// \file
/// Pairs that give way, where the exchange of all wrong pairs at once runs in circles.
#pragma once
#include "signorini/solvers/solvers.hpp"

namespace signorini {

/// Finds out what frictional pairs do by making them soft: each gets a compliance of its own in the way of every
/// force, which counts from the forces of the solution before [\ref Rockafellar1976b]. Soft pairs settle in a few
/// exchanges, one that starts from their statuses hardly has to change any, and with them the compliance becomes 0: it
/// is halved where primal_dual_iterations() settles, and four times as large where it does not. Where soft pairs no longer
/// change, primal_dual_iterations() may end it.
/// \param problem  with friction
/// \param options  not looked at: the softness bounds the iterations
/// \return `Solved`, or `Breakdown` where the first iterate is left
/// \throws std::invalid_argument as check_finite(), with rigid modes as check_problem()
[[nodiscard]] ContactState soft_pairs(const ContactProblem& problem,
                                      const SolverOptions& options = {});

/// \return the member of the family
[[nodiscard]] Solver soft_pairs();

}  // namespace signorini

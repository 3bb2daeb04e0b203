// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The methods that this add-on asks before those that a member names.
#pragma once
#include "signorini/solvers/solvers.hpp"

namespace signorini {

/// Solves a problem with rigid modes whose load has no resultant: no pair has a force, at the least of the rigid motions
/// after which none overlaps. Where so many pairs just touch, exchanges follow forces that are nothing but rounding. It ends
/// `Solved`, or as `Breakdown` where the load has a resultant, or where that is no solution.
/// \return the member of the family
[[nodiscard]] Solver at_rest();

/// Finds out what frictional pairs do by making them soft: each gets a compliance of its own in the way of every
/// force, which counts from the forces of the solution before [\ref Rockafellar1976b]. Soft pairs settle in a few
/// exchanges, one that starts from their statuses hardly has to change any, and with them the compliance becomes 0: it
/// is halved where primal_dual_iterations() settles, and four times as large where it does not. Where soft pairs no longer
/// change, primal_dual_iterations() may end it. It ends `Solved`, or as `Breakdown` where the first iterate is left.
/// \return the member of the family
[[nodiscard]] Solver soft_pairs();

}  // namespace signorini

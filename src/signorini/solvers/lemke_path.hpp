/// \file
/// Friction and rigid modes as one linear complementarity problem, for lemke().
#pragma once
#include "signorini/solvers/iterate.hpp"

namespace signorini {

/// Follows Lemke's path through all kinds of contact, see lemke().
/// \param problem  scaled
/// \param options  of each path
/// \param[in,out] iterate  its report is continued
void follow_pivots(const ScaledProblem& problem, const SolverOptions& options, Iterate& iterate);

}  // namespace signorini

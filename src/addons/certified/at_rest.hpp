/// \file
/// Bodies that nothing pushes.
#pragma once
#include "signorini/solvers/solvers.hpp"

namespace signorini {

/// Solves a problem with rigid modes whose load has no resultant: no pair has a force, at the least of the rigid motions
/// after which none overlaps. Where so many pairs just touch, exchanges follow forces that are nothing but rounding.
/// \param problem  with rigid modes
/// \param options  not looked at
/// \return `Solved`; `Breakdown` where the load has a resultant, or where that is no solution
/// \throws std::invalid_argument as check_problem()
[[nodiscard]] ContactState at_rest(const ContactProblem& problem,
                                   const SolverOptions& options = {});

/// \return the member of the family
[[nodiscard]] Solver at_rest();

}  // namespace signorini

// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Scenes by certified_solve(), with all that can be said of the end.
#pragma once
#include "signorini/scene/solution.hpp"

namespace signorini {

/// Solves a condensed model by certified_solve(). Notes say which motions and forces are not determined, whether other
/// solutions exist, how well forces are known, and what sliding would do to them; `unbounded_direction` and `limit` of the
/// solution say why a load is not held.
/// \param model      from build()
/// \param condensed  from condense() of it
/// \param solver     a member of its family that takes friction where pairs have friction
/// \param ledger     goes on in the solution, with the phases `contact`, `refinement`, `recovery`
/// \param options    handed to the solver
/// \return the solution
/// \throws as solve()
[[nodiscard]] Solution certified_solve(const Model& model, const Condensed& condensed,
                                       const Solver& solver, Ledger ledger,
                                       const SolverOptions& options);

/// Makes it the way in which solve() solves models from now on.
void register_certified();

}  // namespace signorini

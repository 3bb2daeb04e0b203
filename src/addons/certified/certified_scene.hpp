// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Scenes by certified_solve(), with all that can be said of the end.
#pragma once
#include "signorini/scene/solution.hpp"

namespace signorini {

/// Solves a condensed model by certified_solve(). Notes say which motions are not determined, whether other
/// solutions exist and how well forces are known; `unbounded_direction` and `limit` of the
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

/// Up to which force a row carries none: a share, which a certificate lets pass, of the largest force and load of the
/// system that it is in; or what rounding of the entries of K makes along its rigid motions, if that is more.
/// \param model    that was solved
/// \param refined  of its solution
/// \param known    of the matrices of the model; nothing if they are not
/// \return `n_c + n_s` [force]
[[nodiscard]] Eigen::VectorXd no_forces(const Model& model, const PrimalDual& refined,
                                        const KnownMatrices& known = {});

/// Makes it the way in which solve() solves models from now on.
void register_certified();

}  // namespace signorini

/// \file
/// Primal-dual active set method with a safeguard that makes it finite.
#pragma once
#include "signorini/complementarity/problem.hpp"

namespace signorini {

/// Solves a contact problem by exchanging all wrong pairs at once.
///
/// Take the pairs that overlap as closed, compute the forces that close them exactly, release every
/// pair in tension, close every pair that now overlaps, and repeat
/// [\ref HintermuellerItoKunisch2002]. This is fast but can run in circles. When a set of closed
/// pairs comes back, only the wrong pair with the lowest number changes sides from then on, which
/// for a positive definite G ends after finitely many steps [\ref Murty1974]. A pair counts as
/// wrong only beyond the rounding errors of its own force or gap.
///
/// \param problem  G positive semidefinite; blocks of closed pairs must be regular
/// \param options  `iteration_limit` 0 stands for 10 n_c + 10
/// \return `Solved` with forces and gaps >= 0, `Breakdown` if a block is singular to working
///   precision, `IterationLimit` if a set with wrong pairs is left at the limit
/// \throws std::invalid_argument as check_problem()
[[nodiscard]] ContactState primal_dual_active_set(const ContactProblem& problem,
                                                  const SolverOptions& options = {});

}  // namespace signorini

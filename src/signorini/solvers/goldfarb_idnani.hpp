/// \file
/// The dual active set method of Goldfarb and Idnani.
#pragma once
#include "signorini/problem/problem.hpp"

namespace signorini {

/// Solves a contact problem by closing one overlapping pair at a time [\ref GoldfarbIdnani1983].
///
/// The closed pairs W always carry forces >= 0 that close them exactly. The pair p that overlaps most
/// is pressed until it closes, while the forces of W change by \f$ -r = -G_{WW}^{-1} G_{Wp} \f$ per
/// unit force to keep W closed; a pair whose force reaches zero on the way leaves W. Whenever p has
/// closed, the dual energy has grown, so no set comes back, ties or not, and the method is finite. If p
/// depends on W and no force falls, the change of forces proves that nothing solves the problem.
///
/// A Cholesky factor of G_WW is kept up to date by Givens rotations.
///
/// \param problem  G positive semidefinite, and d
/// \param options  `iteration_limit` 0 stands for 100 n_c + 100
/// \return `Solved`, `Infeasible` with the proof, `IterationLimit`, or `Breakdown` if rounding decides
///   what is closed. `iterations` counts pairs that joined or left W; the history has an entry whenever
///   all pairs of W are closed
/// \throws std::invalid_argument as check_problem()
[[nodiscard]] ContactState goldfarb_idnani(const ContactProblem& problem,
                                           const SolverOptions& options = {});

}  // namespace signorini

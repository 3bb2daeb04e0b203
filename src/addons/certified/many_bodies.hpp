// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Many bodies that contact alone holds: solved by the entries that are there, before any method sees a dense matrix.
#pragma once
#include <optional>

#include "addons/certified/certified_solve.hpp"

namespace signorini {

/// Rigid motions from which on bodies are many: with fewer, dense factors are as fast, and know more of a singular system.
inline constexpr Eigen::Index many_motions = 24;

/// Whether the sparse system is worth asking.
/// \param motions  n_r that contact alone stops
/// \param solver   that was asked for: only the default, with all its helpers, is replaced
/// \param options  a limit on iterations is one of that solver
/// \return whether it is
[[nodiscard]] bool many_bodies(Eigen::Index motions, const Solver& solver,
                               const SolverOptions& options);

/// \param problem  any
/// \return whether it is one of held bodies with friction whose F has one entry in 64 at most, as piles of rigid bodies have
[[nodiscard]] bool few_entries(const ContactProblem& problem);

/// Solves a programme by solve_sparse_contact().
/// \param programme     K, p, A, g as they were posed; slips in the last rows of A
/// \param condensed     made of it
/// \param null_vectors  N `n x n_r`
/// \param options       whose statuses are the start
/// \param ledger        gets the phases `contact` and `refinement`
/// \return the end, if its certificate holds
[[nodiscard]] std::optional<CertifiedSolution> many_bodies_solution(
    const QuadraticProgramme& programme, const CondensedProgramme& condensed,
    const Eigen::MatrixXd& null_vectors, const SolverOptions& options, Ledger& ledger);

/// The same of a condensed problem.
/// \param problem  with rigid motions, or few_entries()
/// \param options  whose statuses are the start
/// \return forces, gaps and amplitudes, if their certificate holds
[[nodiscard]] std::optional<ContactState> many_bodies_state(const ContactProblem& problem,
                                                            const SolverOptions& options);

}  // namespace signorini

// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Many bodies that contact alone holds: solved by the entries that are there, before any method sees a dense matrix.
#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "addons/certified/certified_solve.hpp"
#include "signorini/scene/solution.hpp"

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

/// Whether a model is solved by the entries of K and A, before anything is condensed.
/// \param plan  of it
/// \return whether its rigid motions are many, it has neither load steps nor equations, and whoever factors K works alone
[[nodiscard]] bool solved_whole(const Plan& plan);

/// With more rows the compliance alone takes more than 3 GB, and each of many dense factors minutes.
inline constexpr Eigen::Index most_dense_rows = 20000;

/// Solves a model that is solved_whole() by its entries. Pairs with friction are not asked whether other solutions exist.
/// \param model      from build()
/// \param condensed  of it, without its compliance
/// \param ledger     gets the phases `contact` and `refinement`
/// \param most_rows  of A up to which dense methods may be asked after it
/// \return the solution, if it is certified; if not, nothing, or an end as Breakdown where no dense method may be asked
[[nodiscard]] std::optional<CertifiedSolution> whole_solution(
    const Model& model, const Condensed& condensed, Ledger& ledger,
    Eigen::Index most_rows = most_dense_rows);

/// \param problem  any
/// \return whether it is one of held bodies with friction whose F has one entry in 64 at most, as piles of rigid bodies have
[[nodiscard]] bool few_entries(const ContactProblem& problem);

/// What solve_sparse_contact() needs of a programme besides K, p, A and g.
struct ManyBodies {
  FrictionLaw law;        ///< of the frictional pairs, whose slips are in the last rows of A
  Eigen::VectorXd scale;  ///< of each row, see SparseContact
  std::vector<ContactStatus> start = {};  ///< to begin with, or empty
};

/// \param programme  K, p, A, g
/// \return of each row the scale that its length, measured by the diagonal of K, gives it; 0 of a row without entries
[[nodiscard]] Eigen::VectorXd entry_scales(const QuadraticProgramme& programme);

/// Solves a programme by solve_sparse_contact().
/// \param programme        K, p, A, g as they were posed
/// \param bodies           of it
/// \param solve_stiffness  u of K u = p, with a spring for each rigid motion
/// \param null_vectors     N `n x n_r`
/// \param ledger           gets the phases `contact` and `refinement`
/// \return the end, if its certificate holds
[[nodiscard]] std::optional<CertifiedSolution> many_bodies_solution(
    const QuadraticProgramme& programme, const ManyBodies& bodies,
    const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& solve_stiffness,
    const Eigen::SparseMatrix<double>& null_vectors, Ledger& ledger);

/// Forces, gaps and slips of such a programme, and no more.
/// \param programme  K, p, A, g
/// \param bodies     of it
/// \return a state that is Solved, if the certificate holds
[[nodiscard]] std::optional<ContactState> many_bodies_state(const QuadraticProgramme& programme,
                                                            const ManyBodies& bodies);

/// The same for a programme that has been condensed.
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

// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// From a condensed programme to a certified solution.
#pragma once
#include <Eigen/Core>

#include "addons/certified/known_forces.hpp"
#include "signorini/solvers/refined_solve.hpp"

namespace signorini {

/// What certified_solve() found.
struct CertifiedSolution : RefinedEnd {
  ForceUncertainty force_uncertainty = {};  ///< of a solution, from force_uncertainty()
};

/// Solves the condensed problem, refines what the solver claims, and looks at all signs again.
///
/// What the pairs do is the claim; displacements and forces follow from the original data, see
/// iterative_refinement(). Pairs that are then on the wrong side change, as long as they become fewer. Else the
/// condensed problem is corrected, so that it gives the movements of the last set whose refinement settled,
/// and solved again. It ends when all signs are right; when a set of pairs comes back, between which
/// rounding cannot decide; when no refinement of a claim settles; or at the second pass in a row that does not
/// halve the worst figure of the certificate. The best certificate then says whether that matters. A method that
/// ends without a solution is asked the same way: what it looked at last may be right. Where a member breaks
/// down, or ends at its own limit of iterations, the others that its line in the table names are asked in the same way from
/// the start, and the first solution counts. A solution that is expected is looked at for the statuses that the solver claims, before the claim itself is refined.
/// \param programme     K, p, A, g as they were posed; slips in the last rows of A
/// \param condensed     made of it
/// \param null_vectors  N `n x n_r`, or nothing
/// \param solver        a member that takes such problems
/// \param options       handed to it
/// \param ledger        gets the phases `contact` and `refinement`, and counts of sets and solves
/// \return the end
/// \throws ProblemError, std::invalid_argument as the solver
[[nodiscard]] CertifiedSolution certified_solve(const QuadraticProgramme& programme,
                                                const CondensedProgramme& condensed,
                                                const Eigen::MatrixXd& null_vectors,
                                                const Solver& solver, const SolverOptions& options,
                                                Ledger& ledger);

}  // namespace signorini

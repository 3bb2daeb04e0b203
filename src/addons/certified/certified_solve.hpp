// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// From a condensed programme to a certified solution.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <vector>

#include "addons/certified/iterative_refinement.hpp"
#include "addons/certified/known_forces.hpp"
#include "signorini/core/ledger.hpp"
#include "signorini/solvers/solvers.hpp"

namespace signorini {

/// A programme with the displacements eliminated, and the way back.
struct CondensedProgramme {
  const ContactProblem& problem;             ///< F, d, s, law, R, r
  const Eigen::VectorXd& free_displacement;  ///< u0 = K^-1 p `n` [length]
  /// K^-1 applied to a vector [force] -> [length]; with rigid modes that of the grounded K
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> solve_stiffness;
  /// The same for unknowns that no entry of K joins with others, of load and displacement of these alone, at a cost that does
  /// not grow with the others; without it, or if it returns nothing, solve_stiffness is asked with no other load
  std::function<std::function<Eigen::VectorXd(const Eigen::VectorXd&)>(
      const std::vector<Eigen::Index>&)>
      solve_part = {};
};

/// What certified_solve() found. Unless `state.report.status` is Solved, the numbers are those of the best set that could
/// be refined, or empty if none could.
struct CertifiedSolution {
  PrimalDual solution;  ///< u in two parts, and the forces of all rows of A
  /// The same forces, gaps, slips and amplitudes, what the pairs do, and the report
  ContactState state;
  Certificate certificate = uncertified();  ///< of `solution`, from the original data
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
/// the start, and the first solution counts.
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

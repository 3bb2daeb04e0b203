/// \file
/// From a condensed programme to a solution with a certificate.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <vector>

#include "signorini/core/ledger.hpp"
#include "signorini/problem/iterative_refinement.hpp"
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

/// Where a programme ended. Unless `state.report.status` is Solved, the numbers are those of the best set that could be
/// refined, or empty if none could.
struct RefinedEnd {
  PrimalDual solution;  ///< u in two parts, and the forces of all rows of A
  /// The same forces, gaps, slips and amplitudes, what the pairs do, and the report
  ContactState state;
  Certificate certificate = uncertified();  ///< of `solution`, from the original data
};

/// Solves a condensed programme: the members of a portfolio claim, the certificate decides.
///
/// The member, then those that it names in `others`, are asked one by one. What a member hands on are numbers: the statuses
/// of all pairs, forces and amplitudes. iterative_refinement() makes displacements and forces of them that fit K, p, A and g;
/// where check_signs() then finds pairs on the wrong side, they change, three times at most. The first end whose certificate
/// holds is the solution, also if the member itself was not sure.
/// \param programme     K, p, A, g as they were posed; slips in the last rows of A
/// \param condensed     made of it
/// \param null_vectors  N `n x n_r`, or nothing
/// \param solver        a member that takes such problems
/// \param options       handed to it; with a limit on iterations no other member is asked
/// \param ledger        gets the phases `contact` and `refinement`, and counts of sets and solves
/// \return the end
/// \throws ProblemError, std::invalid_argument as the solver
[[nodiscard]] RefinedEnd refined_solve(const QuadraticProgramme& programme,
                                       const CondensedProgramme& condensed,
                                       const Eigen::MatrixXd& null_vectors, const Solver& solver,
                                       const SolverOptions& options, Ledger& ledger);

/// Sets contact forces that are negative to 0, which are of rounding size, where the certificate still holds then.
/// \param programme  as posed
/// \param law        of the frictional pairs
/// \param[in,out] end  whose certificate holds
void drop_tension(const QuadraticProgramme& programme, const FrictionLaw& law, RefinedEnd& end);

}  // namespace signorini

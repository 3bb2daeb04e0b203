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
  const KnownMatrices* known = nullptr;  ///< of K, A and law; null if they are not known
  const PrimalDual* expected = nullptr;  ///< u in two parts and forces, where the solution is likely; null: not known
};

/// Where a programme ended. Unless `state.report.status` is Solved, the numbers are those of the best set that could be
/// refined, or empty if none could.
struct RefinedEnd {
  PrimalDual solution;  ///< u in two parts, and the forces of all rows of A
  /// The same forces, gaps, slips and amplitudes, what the pairs do, and the report
  ContactState state;
  Certificate certificate = uncertified();  ///< of `solution`, from the original data
};

/// Sets of closed pairs that are refined one after the other, each from where the one before ended. The best certificate counts.
struct RefinedSets {
  /// Where the last set ended.
  struct Place {
    PrimalDual now;             ///< to begin with, u without contact and no force
    Eigen::VectorXd amplitude;  ///< of the rigid motions that have gone into `now` `n_r`
    RefinedSolution last = {};  ///< the set; its solution has become `now`
  };
  RefinementData data;        ///< the problem
  Ledger& ledger;             ///< gets counts of sets and solves
  RefinedEnd& end;            ///< gets solution, certificate and amplitude of the best set
  Place here;                 ///< where they stand
  RefinedSolution best = {};  ///< movement and system of the best set
  std::vector<ContactStatus> statuses = {};  ///< `n_c` of the best set; empty before the first
  bool confirmed = false;                    ///< whether all signs of the best set are right

  /// Refines one more set; it is the best if all its signs are right, or if no certificate before was better.
  /// \param of     statuses `n_c` \param force  of all rows, to begin with [force] \return what check_signs() says
  SignCheck refine(const std::vector<ContactStatus>& of, const Eigen::VectorXd& force);
  /// Certifies `here.last`, and keeps it if it is the best. \param of  its statuses `n_c` \return what check_signs() says
  SignCheck take(const std::vector<ContactStatus>& of);
};

/// Whether a claim is worth refining. A proof that nothing solves the problem has no numbers; a method that broke down may still
/// have the right statuses of its pairs. \param claim  what a solver says \param pairs  of its problem \return whether
[[nodiscard]] bool usable(const ContactState& claim, Eigen::Index pairs);

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

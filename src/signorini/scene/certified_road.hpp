/// \file
/// From a condensed problem to a certified end, with friction and without, held or floating.
#pragma once
#include <string>
#include <vector>

#include "signorini/programme/refine.hpp"
#include "signorini/scene/solution.hpp"

namespace signorini {

/// Where the road ended. Displacements are there if any set of pairs could be refined.
struct CertifiedEnd {
  PrimalDual solution;                      ///< u, and the forces of all rows of A
  Eigen::VectorXd movement;                 ///< gaps, then slips, of u [length]
  Eigen::VectorXd amplitude;                ///< of the rigid modes `n_r`
  std::vector<Motion> motions;              ///< what the pairs do `n_c`
  Certificate certificate = uncertified();  ///< from the original data
  Report report;                            ///< of all passes of the solver; Solved if certified
  Uniqueness uniqueness = Uniqueness::Unknown;  ///< of a solution with friction
  std::string reason;                           ///< what stopped the method, if it says
  Eigen::VectorXd escape;                       ///< proof that the load pulls a body away, or empty
  Eigen::VectorXd infeasibility;                ///< proof that gaps contradict each other, or empty
};

/// Solves the condensed problem, refines what its solver claims, and looks at all signs again.
///
/// What the pairs do is the claim; displacements and forces follow from the original data, see
/// refine(). Pairs that are then on the wrong side change, as long as they become fewer. Else the
/// condensed problem is corrected, so that it gives the refined movements, and solved again. The road ends
/// when all signs are right; when a set of pairs comes back, between which rounding cannot decide; when
/// refinement does not settle; or at the second pass in a row that does not halve the worst figure of the
/// certificate. The best certificate then says whether that matters. A method that ends without a solution
/// is asked the same way: what it looked at last may be right.
/// \param model      from build()
/// \param condensed  from condense() of it
/// \param solver     name in solvers(), or with friction in friction_solvers()
/// \param[in,out] ledger  receives the phases `contact` and `refinement`
/// \return the end; `Solved` only with a certificate that holds
/// \throws ProblemError for an unknown name
[[nodiscard]] CertifiedEnd certified_end(const Model& model, const Condensed& condensed,
                                         const std::string& solver, Ledger& ledger);

}  // namespace signorini

// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// How well the forces of a solution are known: a certificate speaks of residuals, this of errors.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/core/alignment.hpp"
#include "signorini/problem/iterative_refinement.hpp"

namespace signorini {

/// One rounding of every term of the movements of a solution, what they are known to at best.
/// \param programme  A and g
/// \param solution   u
/// \return `n_c + n_s` [length]
[[nodiscard]] Eigen::VectorXd movement_rounding(const QuadraticProgramme& programme,
                                                const PrimalDual& solution);

/// A share of the largest force. Where forces are known better no note is worth reading, for no length, modulus or load
/// was measured so well; a larger share would keep silent about some of the six digits that are printed.
inline constexpr double known_well = 1e-6;

/// What rounding of the gaps may have done to the forces.
struct ForceUncertainty {
  Eigen::Index pair = -1;  ///< whose force, or friction force, it may have moved most; -1 if none
  double share = 0;  ///< by how much, of the largest force [-], from 0 to 1: nothing is known of it
};

/// Estimates how far one rounding of every term of the gaps moves the forces that close them.
///
/// A gap is known to \f$ \delta = \tfrac12\epsilon\,(|g| + |A|\,|u|) \f$ at best: a solution whose closed gaps are zero
/// to the last digit has forces that are wrong by \f$ M^{-1}\delta \f$, with M the system of ActiveSetSystem. Where a pattern of
/// forces moves hardly anything, as plus and minus in turns do on a soft side that has fewer nodes than the stiff one,
/// this is any number of digits, and no certificate sees it. The worst signs of the entries of delta are looked for as
/// in Hager's estimate of condition numbers [\ref Higham2002]: a few solves, each with the signs of the answer before.
/// Open pairs that are as near as check_signs() takes for rounding belong to the system, for rounding may have opened them.
///
/// Forces that could be others because rows of A repeat each other, \f$ A^T\Delta\lambda = 0 \f$, as those of several
/// Gauss points do, are no doubt of this kind: they are among several solutions, and nothing else depends on them. K, A
/// and g count as they were posed. What M says of a singular system that is not symmetric is not known.
/// \param data      the problem
/// \param refined   from iterative_refinement(): only movement and system count
/// \param solution  u and forces `n_c + n_s`, as refined
/// \param statuses   `n_c` that iterative_refinement() was given
/// \return pair and share
[[nodiscard]] ForceUncertainty force_uncertainty(const RefinementData& data,
                                                 const RefinedSolution& refined,
                                                 const PrimalDual& solution,
                                                 std::vector<ContactStatus> statuses);

}  // namespace signorini

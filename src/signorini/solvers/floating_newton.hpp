/// \file
/// Newton's methods for contact, with the rigid modes of floating bodies among the unknowns.
#pragma once
#include "signorini/problem/floating.hpp"

namespace signorini {

/// Semismooth Newton method for the Fischer-Burmeister equations of a floating problem.
/// \PaperEq{LinEtAl, 28}, \PaperEq{LinEtAl, 30}
///
/// \f[ \varphi(gap_i, \lambda_i) = 0,\qquad R^T\lambda = r,\qquad gap = d + G\lambda + R a. \f]
///
/// It starts from the least forces that balance the load, for one mode of equal pairs the equal share of
/// each, and from the amplitudes of least gaps. As every step keeps \f$ R^T\lambda = r \f$, only
/// two things are left to find: how forces in balance differ from those, and a. With U an orthonormal
/// basis of the columns of R and \f$ P = I - U U^T \f$, the gaps that they make are
/// \f$ P G P \lambda + U b \f$: neither how far away a body was put nor the springs that ground it in G are
/// left in the equations. A force counts as the gap that such forces on all pairs make, with the largest
/// row sum of |P G P|. The step is shortened, turned and ended as by the fischer_burmeister() of a
/// ContactProblem.
/// \param problem  G, d, R, r
/// \param options  `iteration_limit` 0 stands for 10 n_c + 100
/// \return `Solved` with a certificate, `Breakdown` if the residual falls no more at a point that is no
///   solution, as where a load pulls the body away; `IterationLimit`
/// \throws std::invalid_argument as check_problem(), or if R or r do not fit
[[nodiscard]] FloatingState fischer_burmeister(const FloatingProblem& problem,
                                               const SolverOptions& options = {});

/// Active sets for a floating problem: closes the pairs of a set with the resultant kept, releases those
/// in tension, closes those that overlap, and repeats until no pair is wrong
/// [\ref HintermuellerItoKunisch2002].
///
/// The first set are the pairs that would be nearer than the gap their share of the load makes, from the
/// start of the fischer_burmeister() above.
/// \param problem  G, d, R, r
/// \param options  `iteration_limit` 0 stands for 10 n_c + 10
/// \return `Solved` with a certificate; `Breakdown` if a set does not hold the body or comes back, for
///   which there is no safeguard; `IterationLimit`
/// \throws std::invalid_argument as check_problem(), or if R or r do not fit
[[nodiscard]] FloatingState primal_dual_active_set(const FloatingProblem& problem,
                                                   const SolverOptions& options = {});

}  // namespace signorini

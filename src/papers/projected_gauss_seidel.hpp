// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Projected Gauss-Seidel sweeps.
#pragma once
#include "signorini/problem/problem.hpp"

namespace signorini {

/// Solves a contact problem by sweeps over the pairs: each in turn gets the force that closes it while
/// all others stay, or none if it would have to pull [\ref Cryer1971].
///
/// For a symmetric positive definite G every step lowers the energy and the sweeps converge, by a
/// factor per sweep that comes close to 1 if G is ill-conditioned. When a sweep leaves the set of pairs
/// with a force as it was, this set is closed exactly; if that is the solution, the method ends with it.
/// It never ends with forces that sweeps have only brought near.
///
/// For other matrices with a positive diagonal the sweeps may or may not converge. If G is singular,
/// forces that solve the problem may be spread over dependent pairs, which cannot be closed exactly, and
/// if gaps contradict each other the forces grow without end: both reach the limit.
///
/// \param problem  M and q with M_ii > 0; M_ii = 0 is allowed in rows and columns of zeros
/// \param options  `iteration_limit` 0 stands for 1000 + 10 n_c sweeps
/// \return `Solved`, `IterationLimit`, or `Breakdown` if a diagonal entry is negative, or zero in a row or
///   column that is not: its own force cannot close such a pair. The history keeps sweeps 0 to 31 and then 16 of
///   each doubling: every 2nd from 32 on, every 4th from 64 on, ...; tension is zero throughout
/// \throws std::invalid_argument as check_finite()
[[nodiscard]] ContactState projected_gauss_seidel(const ContactProblem& problem,
                                                  const SolverOptions& options = {});

}  // namespace signorini

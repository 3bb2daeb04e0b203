/// \file
/// Friction as one equation per pair and direction, solved by Newton's method.
#pragma once
#include "signorini/problem/friction.hpp"
#include "signorini/solvers/friction_descent.hpp"

namespace signorini {

/// Solves a friction problem by Newton's method on one normal and one tangential equation per pair.
///
/// The normal equation is that without friction, \PaperEq{LinEtAl, 28}. The friction force lies between
/// -b and b, at -b while the pair slides forwards and at b while it slides backwards: with
/// fischer_burmeister(), applied twice [\ref Billups1995],
///
/// \f[ \varphi(\tau + b, \varphi(b - \tau, -slip)) = 0,\qquad b = \mu\max(\lambda, 0) + c, \f]
///
/// with c of pairs only whose force exceeds their gap. There is no pair of unknowns u+ and u- as in
/// friction_split(), and where b = 0 the equation just says tau = 0. All is scaled, and every step goes as
/// far as the residual falls. Whenever an iterate says something new of what the pairs do, these motions
/// are solved exactly, and the result is kept if all signs are right beyond rounding.
///
/// If that does not end in a solution, exchange_motions() and then friction_lemke() go on from there; the
/// last one finds a solution of every held body without cohesion.
///
/// \param problem  F positive semidefinite, d, s, mu, c, R, r
/// \param options  `iteration_limit` 0 stands for 25 Newton steps; with a limit nothing follows them
/// \return `Solved`; `Infeasible` with `escape` if no forces balance r; else what friction_lemke() said,
///   or with a limit `IterationLimit` or `Breakdown` if no step lowers the residual. `uniqueness` is that of
///   uniqueness(), and `report.history` holds |Phi| relative to its first value as `residual`
/// \throws std::invalid_argument as check_problem()
[[nodiscard]] FrictionState friction_newton(const FrictionProblem& problem,
                                            const SolverOptions& options = {});

/// Newton steps of friction_newton() and friction_split() if the caller sets no limit.
inline constexpr Eigen::Index newton_limit = 25;

/// The Newton steps alone, on a scaled problem.
/// \param problem  scaled by equilibrate()
/// \param limit    on the steps
/// \param[in,out] point  where to start, and where it ended; `closure.confirmed` if at a solution
void follow_newton(const ScaledFriction& problem, Eigen::Index limit, FrictionPoint& point);

}  // namespace signorini

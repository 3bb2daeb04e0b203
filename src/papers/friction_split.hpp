// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Friction with two unknowns per slip, u+ and u-: as in Lin et al., and so that it works.
#pragma once
#include "signorini/problem/problem.hpp"

namespace signorini {

/// Solves the equations of the paper, with lambda as a pressure (chapter 9, one sign), by a plain Newton method.
///
/// The slip is split, \PaperEq{LinEtAl, 19}, and the unknowns are the forces lambda, tau, the two parts u+, u-
/// and amplitudes, \PaperEq{LinEtAl, 30}:
///
/// \f[ \varphi(gap, \lambda) = 0,\quad slip - u^+ + u^- = 0,\quad \varphi(u^+, c + \mu\lambda + \tau) = 0,
///     \quad \varphi(u^-, c + \mu\lambda - \tau) = 0. \f]
///
/// Nothing is scaled, no step is shortened, and c is carried across open gaps. The start is zero, or the
/// smallest forces that balance r if there are rigid modes. Where c + mu lambda = 0,
/// as for every open pair without cohesion, both last equations say only tau = 0: u+ and u- enter by
/// their difference, and where both are positive the Jacobian, \PaperEq{LinEtAl, 31}, is singular.
/// \param problem  F, d, s, mu, c, R, r
/// \param options  `iteration_limit` 0 stands for 50; `tolerance` on |Phi| over its first value
/// \return `Solved` only if the certificate of contact holds; `Breakdown` with the pair in `reason` where
///   the Jacobian is singular, or if the equations are solved, but not contact; `IterationLimit`
/// \throws std::invalid_argument as check_problem()
[[nodiscard]] ContactState friction_split_literal(const ContactProblem& problem,
                                                  const SolverOptions& options = {});

/// The same split, repaired.
///
/// All arguments are scaled; only pairs whose force exceeds their gap carry cohesion; every step goes as
/// far as the residual falls; the diagonal of u+ and u- in the Jacobian, whose entries lie between
/// -2 and 0, is lowered by 1e-10, which moves no solution and tells u+ from u- where the bound is zero; and once it is settled what every
/// pair does, that is solved exactly, as in fischer_burmeister(). There is
/// no fallback.
/// \param problem  F, d, s, mu, c, R, r
/// \param options  `iteration_limit` 0 stands for 25
/// \return `Solved`; `Infeasible` with `unbounded_direction` if no forces balance r; `IterationLimit`; `Breakdown` if no
///   step lowers the residual any more
/// \throws std::invalid_argument as check_problem()
[[nodiscard]] ContactState friction_split(const ContactProblem& problem,
                                          const SolverOptions& options = {});

}  // namespace signorini

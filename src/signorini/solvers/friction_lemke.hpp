/// \file
/// Friction as a linear complementarity problem, solved by Lemke's method.
#pragma once
#include "signorini/problem/friction.hpp"
#include "signorini/solvers/friction_descent.hpp"

namespace signorini {

/// Solves a friction problem by complementary pivoting: the method with a proof that it arrives.
///
/// With p = b + tau, q = b - tau and the two parts of the slip, slip = v+ - v-, the conditions are
///
/// \f[ 0\le gap\perp\lambda\ge 0,\quad 0\le v^+\perp p\ge 0,\quad 0\le q\perp v^-\ge 0, \f]
///
/// \PaperEq{LinEtAl, 17}, \PaperEq{LinEtAl, 18}, \PaperEq{LinEtAl, 19}, which with
/// tau = p - mu lambda - c is a linear complementarity problem for (lambda, p, v-) [\ref Klarbring1986]:
///
/// \f[ M = \begin{pmatrix} G - C\mu & C & 0\\ C^T - T\mu & T & I\\ 2\mu & -I & 0\end{pmatrix},\qquad
///     F = \begin{pmatrix} G & C\\ C^T & T\end{pmatrix}. \f]
///
/// For z >= 0, \f$ z^T M z = f^T F f + 2\mu\lambda^T v^- \ge 0 \f$ with f = (lambda, tau + c): M is
/// copositive, and for a positive definite F it belongs to the matrices for which Lemke's method always
/// finds a solution, whatever mu is [\ref CottlePangStone1992]. Rigid amplitudes join as differences
/// of positive numbers, R^T f = r as two inequalities. M stays copositive, but the method now may end on a
/// ray, and it must be able to: that some forces within their bounds balance r does not mean that the
/// bodies press where these forces are needed. With different mu from pair to pair there are such problems
/// without any solution.
///
/// In these equations an open pair carries cohesion. So c is given to a set of pairs, first to all and then
/// to those that came out closed, until both are the same set; that need not happen.
///
/// \param problem  F positive semidefinite, d, s, mu, c, R, r
/// \param options  `iteration_limit` of each run of lemke()
/// \return `Solved`; `Infeasible` with `escape` if no forces balance r; `Ray`, `IterationLimit` and
///   `Breakdown` as lemke() with four covering vectors, the last one also if the sets of cohesive pairs run
///   in circles
/// \throws std::invalid_argument as check_problem()
[[nodiscard]] FrictionState friction_lemke(const FrictionProblem& problem,
                                           const SolverOptions& options = {});

/// The same on a scaled problem.
/// \param problem  scaled by equilibrate()
/// \param options  of each run of lemke()
/// \param[in,out] point  its report is continued; `closure.confirmed` if the method arrived
void follow_lemke(const ScaledFriction& problem, const SolverOptions& options,
                  FrictionPoint& point);

}  // namespace signorini

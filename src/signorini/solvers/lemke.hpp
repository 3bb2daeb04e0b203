/// \file
/// Lemke's complementary pivoting.
#pragma once
#include "signorini/solvers/solvers.hpp"

namespace signorini {

/// Solves w = M z + q, w, z >= 0, w^T z = 0 by complementary pivoting [\ref Lemke1965].
///
/// An artificial force z_0 opens all gaps at once: w = M z + c z_0 + q with the covering vector c > 0.
/// From there on the partner of the variable that has just left the basis enters it, until z_0 leaves.
/// Ties are broken by the lexicographic rule, as if q were perturbed by different powers of a tiny
/// number [\ref CottlePangStone1992], so that no basis comes back. The forces of the last basis are
/// then found anew from the data.
///
/// If G is symmetric and positive semidefinite, the method ends with a solution or with a ray that
/// proves that there is none. In both cases it can pass 2^n bases [\ref Fathi1979]; which problems
/// take so long depends on c.
///
/// \param problem   G and d, or any M and q
/// \param covering  c `n_c` > 0 [length], as q
/// \param options   `iteration_limit` 0 stands for 2^min(n_c, 20) + 100 n_c pivots
/// \return `Solved`; `Infeasible` with the proof, read off a ray; `Ray` if the ray proves nothing, as
///   for a matrix that is no compliance; `IterationLimit`; `Breakdown` if rounding spoiled the last
///   basis. `iterations` counts pivots, the one that brings z_0 in is the first
/// \throws std::invalid_argument unless c has one positive, finite entry per pair, as check_finite(), or for a
///   problem with friction or rigid modes
[[nodiscard]] ContactState lemke(const ContactProblem& problem, const Eigen::VectorXd& covering,
                                 const SolverOptions& options = {});

/// The same, with ones as covering vector of the equilibrated problem: neither units nor the scale of
/// a row change a pivot.
///
/// A path that grows too long is left for one with another covering vector, as which problems take 2^n pivots
/// depends on it: the first may take n_c^2 + 100 n_c pivots, each later one twice as many as the one before. The
/// vectors are always the same, entries between 1 and 2.
///
/// Friction and rigid modes make a larger problem of this kind, and give the method with a proof that it arrives.
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
/// In its equations an open pair carries cohesion. So c is given to a set of pairs, first to all and then
/// to those that came out closed, until both are the same set. If a set comes back, one pair at a time gets or loses
/// its cohesion, never the last one again while another is wrong; where that one alone is left, it closes only
/// without its cohesion and opens only with it, and there is no solution in which all others do what they do there.
///
/// \param problem  any; without friction and rigid modes any M and q
/// \param options  as above, for all paths together; with friction or rigid modes of each path
/// \return as above; `iterations` counts the pivots of all paths. With friction or rigid modes also `Jump` if a set of
///   cohesive pairs cannot be found
/// \throws std::invalid_argument as check_finite(), with rigid modes as check_problem()
[[nodiscard]] ContactState lemke(const ContactProblem& problem, const SolverOptions& options = {});

/// \return the member of the family
[[nodiscard]] Solver lemke();

}  // namespace signorini

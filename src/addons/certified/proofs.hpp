// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What can be proved about a condensed problem: that nothing solves it, or that one solution is all.
#pragma once
#include <optional>
#include <vector>

#include "signorini/problem/active_set_system.hpp"
#include "signorini/problem/certificate.hpp"

namespace signorini {

/// Looks for the proof that nothing solves a problem with a matrix of any kind, for which no set of pairs need give it: y is what
/// the nearest gaps that forces can leave lack of being none below 0, the least \f$ |w - F z - d| \f$ with w, z >= 0, by least squares with bounds
/// [\ref LawsonHanson1995]. Then \f$ F^T y \le 0 \f$ and \f$ d^T y = -|y|^2 \f$.
/// \param problem  scaled, without friction and rigid modes
/// \return y `n_c` in the units of the forces, such that the scaled ones sum to 1, if verify_farkas() holds for the scaled
///   problem; otherwise an empty vector
[[nodiscard]] Eigen::VectorXd farkas_certificate(const ScaledProblem& problem);

/// Looks for the proof that no contact forces balance r: amplitudes a such that the motion
/// \f$ (\delta, v) = R a \f$ opens each gap by at least mu times its slip, \f$ \delta_i \ge \mu_i |v_i| \f$,
/// while the load does more work than all cohesion can take, \f$ r^T a + \sum c_i |v_i| < 0 \f$.
///
/// Then \f$ f^T R a \ge -\sum c_i |v_i| \f$ for all forces within their bounds, so R^T f = r is impossible.
/// The a is the difference between r and the nearest resultant that contact can give, by least squares with
/// bounds [\ref LawsonHanson1995].
/// \param problem  scaled
/// \return a `n_r` in the units of the problem as it was posed if the proof holds to 1e3 epsilon,
///   otherwise an empty vector
[[nodiscard]] Eigen::VectorXd unbounded_direction(const ScaledProblem& problem);

/// How much of a growing load contact can balance: the largest share s of [0, 1] for which no unbounded_direction() proves that
/// no forces within their bounds have the resultant \f$ r_0 + s (r - r_0) \f$.
///
/// Every proof a holds for all s beyond \f$ -(r_0^T a + \sum c_i |v_i|) / ((r - r_0)^T a) \f$; there the next one is
/// looked for. That is Newton's method for the distance from the resultants that contact can give, a polyhedron, so it
/// ends after finitely many proofs, and exactly to rounding. It is the limit theorem of statics: what is beyond s
/// moves away for certain. That all below is held is certain for Tresca's law only, because the sliding of Coulomb's
/// opens no gap as the theorem would have it.
/// \param problem  with R, and r of the full load
/// \param before   r_0 `n_r` that the load grows from; zeros: the whole load grows
/// \return s [-]; 1 if nothing refutes r itself, 0 if not even r_0 or any part beyond it can be balanced
/// \throws std::invalid_argument as check_problem(), or if the sizes of r and r_0 differ
[[nodiscard]] double balanced_share(const ContactProblem& problem, const Eigen::VectorXd& before);

/// The state of a body that its load pulls away, if unbounded_direction() has a proof that holds for R and r as they were posed.
/// \param problem  as it was posed
/// \param scaled   the same, equilibrated
/// \return free gaps and slips, no forces, `Infeasible`; or nothing
[[nodiscard]] std::optional<ContactState> infeasible_resultant(const ContactProblem& problem,
                                                               const ScaledProblem& scaled);

/// Whether the matrices of a problem leave one solution at most, for any free gaps and slips, see uniqueness().
/// \param problem  scaled, of a held body without cohesion, or without friction coefficients
/// \return whether \f$ G - C T^{-1} C^T - \tfrac14\mu\,|T|\,\mu \f$ is positive definite beyond rounding
[[nodiscard]] bool excludes_others(const ScaledProblem& problem);

/// Whether a problem can have several solutions.
///
/// *Proved* means: none of these matrices can, for any free gaps and slips. With F split into G of the gaps, T of
/// the slips and C between them, (Delta lambda, Delta tau) the difference of two solutions and v that of their slips,
///
/// \f[ \Delta\lambda^T (G - C T^{-1} C^T) \Delta\lambda + v^T T^{-1} v \le
///     \sum_i \mu_i |\Delta\lambda_i| |v_i|, \f]
///
/// which leaves no difference if \f$ G - C T^{-1} C^T - \tfrac14\mu\,|T|\,\mu \f$ is positive definite, or
/// if C = 0, so that the normal forces do not feel the friction. It is not claimed with cohesion, whose
/// bound jumps, nor with rigid modes, unless no pair has friction and the pairs that press hold all of them: else the
/// forces are the only ones, but gaps of the same load may not be. *Doubtful* means: there are others for this very
/// load. Either the system of the statuses found has a determinant of the sign opposite to that without friction: the
/// signs of all solutions of a held body without cohesion sum to 1, so there are at least two more. Or one was found: a
/// pair with \f$ \mu_i |C_{ii}| > G_{ii} \f$, which alone has several solutions for some free gaps and slips, does something
/// else, the others follow by predict() while fewer and fewer change, and the end satisfies solves(). Others may exist
/// that are not found so: *Unknown* promises nothing.
/// \param problem   scaled
/// \param statuses   `n_c` of the solution
/// \param solution  a confirmed one
/// \param work      operations that the search for others may take, but one pair is always tried
/// \return the verdict
[[nodiscard]] Uniqueness uniqueness(const ScaledProblem& problem,
                                    const std::vector<ContactStatus>& statuses,
                                    const ActiveSetSolution& solution, double work = 1e8);

/// Which pair a warning of uniqueness() rests on.
///
/// If the determinant of the statuses found has the wrong sign, it is the pair whose mu has to fall least, alone, for the
/// sign to change; -1 if none can do it alone. Otherwise it is the pair for which \f$ 1 - \mu_i |C_{ii}| / G_{ii} \f$ is
/// smallest.
/// \param problem   scaled
/// \param statuses   `n_c` of the solution
/// \param solution  a confirmed one that is `Doubtful`
/// \return pair and determinant
[[nodiscard]] UniquenessWarning uniqueness_warning(const ScaledProblem& problem,
                                                   const std::vector<ContactStatus>& statuses,
                                                   const ActiveSetSolution& solution);

/// Whether numbers prove that nothing satisfies A_e u = g_e and A_i u <= g_i: y_i >= 0, A^T y = 0 and
/// g.y < 0, so that y.(g - A u) < 0 for all u.
///
/// Rounded numbers have A^T y = 0 to rounding only, and g.y > y.(A u) for a u that is large enough. They
/// count as proof if that takes displacements larger than those at hand by half of the digits of a double.
/// \param programme  A, g; with friction its slips, which have no part in a proof, are the last rows
/// \param y          `m`, or fewer: those of the last rows are 0; those of equations have any sign
/// \param u          `n` displacements that a method has come to
/// \param equations  so many of the first rows are
/// \return whether y proves it
/// \throws std::invalid_argument if u has another size
[[nodiscard]] bool proves_infeasible(const QuadraticProgramme& programme, const Eigen::VectorXd& y,
                                     const Eigen::VectorXd& u, Eigen::Index equations = 0);

}  // namespace signorini

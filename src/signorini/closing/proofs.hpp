/// \file
/// What can be proved about a condensed problem: that nothing solves it, or that one solution is all.
#pragma once
#include <optional>
#include <vector>

#include "signorini/closing/closing.hpp"

namespace signorini {

/// Whether y proves that nothing solves a problem, checked on the original data in twice the working precision.
///
/// With y >= 0 on the gaps, \f$ F^T y = 0 \f$, R^T y = 0 and d^T y < 0 the gaps of any forces and amplitudes sum
/// to \f$ y^T(d + F f + R a) = d^T y < 0 \f$. Computed numbers give F^T y = 0 but for rounding, allowed here to
/// be 1e3 epsilon of the largest that it could be; so the forces that lift the sum to zero, at least
/// \f$ -d^T y / \max_i |F^T y|_i \f$, must be out of reach as well: beyond \f$ 1/\sqrt{\epsilon} \f$ times the
/// one that closes the deepest free overlap alone, all in the units of equilibrate(). And d^T y must exceed what
/// rounding did to d. The same is asked of a programme by proves_infeasible().
/// \param problem  as it was posed, or any M and q
/// \param y        `n_c`, or of another size, which proves nothing
/// \return whether it does
[[nodiscard]] bool refutes(const ContactProblem& problem, const Eigen::VectorXd& y);

/// Looks for the proof that nothing solves a problem: y with y_p = 1 and \f$ y_W = -G_{WW}^{-1} G_{Wp} \f$,
/// the forces that hold the pairs of a set where they are while one more is pressed.
/// \param problem  scaled, without friction
/// \param active   W, without p
/// \param pair     p, which depends on W
/// \return y `n_c` in the units of the forces, such that the scaled ones sum to 1, if it refutes() the scaled
///   problem; otherwise an empty vector
[[nodiscard]] Eigen::VectorXd contradiction(const ScaledProblem& problem,
                                            const std::vector<Eigen::Index>& active,
                                            Eigen::Index pair);

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
[[nodiscard]] Eigen::VectorXd escape(const ScaledProblem& problem);

/// The state of a body that its load pulls away, if escape() has a proof that holds for R and r as they were posed.
/// \param problem  as it was posed
/// \param scaled   the same, equilibrated
/// \return free gaps and slips, no forces, `Infeasible`; or nothing
[[nodiscard]] std::optional<ContactState> pulled_away(const ContactProblem& problem,
                                                      const ScaledProblem& scaled);

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
/// bound jumps, nor with rigid modes, unless nothing rubs and the pairs that press hold all of them: else the
/// forces are the only ones, but gaps of the same load may not be. *Doubtful* is a warning: either
/// \f$ \mu_i |C_{ii}| > G_{ii} \f$ for some pair, which alone already has several solutions for some free
/// gaps and slips; or the system of the motions found has a determinant of the sign opposite to that
/// without friction, which for held bodies without cohesion means that there are others. Neither is
/// needed for several solutions to exist: *Unknown* promises nothing.
/// \param problem   scaled
/// \param solution  a confirmed one
/// \return the verdict
[[nodiscard]] Uniqueness uniqueness(const ScaledProblem& problem, const Closure& solution);

}  // namespace signorini

/// \file
/// What can be proved about a friction problem: that nothing balances its load, or that one solution is all.
#pragma once
#include "signorini/solvers/friction_descent.hpp"

namespace signorini {

/// Looks for the proof that no contact forces balance r: amplitudes a such that the motion
/// \f$ (\delta, v) = R a \f$ opens each gap by at least mu times its slip, \f$ \delta_i \ge \mu_i |v_i| \f$,
/// while the load does more work than all cohesion can take, \f$ r^T a + \sum c_i |v_i| < 0 \f$.
///
/// Then \f$ f^T R a \ge -\sum c_i |v_i| \f$ for all forces within their bounds, so R^T f = r is impossible.
/// The a is the difference between r and the nearest resultant that contact can give, from lemke().
/// \param problem  scaled by equilibrate()
/// \return a `n_r` in the units of the problem as it was posed if the proof holds to 1e3 epsilon,
///   otherwise an empty vector
[[nodiscard]] Eigen::VectorXd escape(const ScaledFriction& problem);

/// Whether a problem of these matrices can have several solutions.
///
/// *Proved* means: none can, for any free gaps and slips. If (Delta lambda, Delta tau) is the difference
/// of two solutions and v that of their slips,
///
/// \f[ \Delta\lambda^T (G - C T^{-1} C^T) \Delta\lambda + v^T T^{-1} v \le
///     \sum_i \mu_i |\Delta\lambda_i| |v_i|, \f]
///
/// which leaves no difference if \f$ G - C T^{-1} C^T - \tfrac14\mu\,|T|\,\mu \f$ is positive definite, or
/// if C = 0, so that the normal forces do not feel the friction. It is not claimed with cohesion, whose
/// bound jumps, nor with rigid modes, unless nothing rubs. *Doubtful* is a warning: either
/// \f$ \mu_i |C_{ii}| > G_{ii} \f$ for some pair, which alone already has several solutions for some free
/// gaps and slips; or the system of the motions found has a determinant of the sign opposite to that
/// without friction, which for held bodies without cohesion means that there are others. Neither is
/// needed for several solutions to exist: *Unknown* promises nothing.
/// \param problem   scaled by equilibrate()
/// \param solution  a confirmed one
/// \return the verdict
[[nodiscard]] Uniqueness uniqueness(const ScaledFriction& problem, const FrictionClosure& solution);

/// The state of a body that its load pulls away.
/// \param problem  as it was posed
/// \param scaled   the same, equilibrated
/// \param way      from escape()
/// \return free gaps and slips, no forces, `Infeasible`
[[nodiscard]] FrictionState escaping(const FrictionProblem& problem, const ScaledFriction& scaled,
                                     Eigen::VectorXd way);

/// The state where a method ended: Solved if it was confirmed, else not.
/// \param problem  as it was posed
/// \param scaled   the same, equilibrated
/// \param point    the end
/// \return the state, with its uniqueness
[[nodiscard]] FrictionState finished_state(const FrictionProblem& problem,
                                           const ScaledFriction& scaled, FrictionPoint point);

}  // namespace signorini

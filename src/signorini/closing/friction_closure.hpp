/// \file
/// The one linear system that every friction solver ends with: what all pairs do is known.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "signorini/closing/known_set.hpp"
#include "signorini/problem/friction.hpp"

namespace signorini {

/// A friction problem with row i scaled by \f$ s_i = 1/\sqrt{F_{ii}} \f$ and the rigid modes made
/// orthonormal: one unit for forces, friction forces, gaps, slips and amplitudes.
///
/// The friction coefficients change with it, \f$ \mu_i s_i / s_{n+i} \f$, because normal and tangential
/// rows have different scales.
struct ScaledFriction {
  Eigen::MatrixXd compliance;   ///< `2 n_c x 2 n_c`, unit diagonal [-]
  Eigen::VectorXd free;         ///< `2 n_c` free gaps, then slips [sqrt(energy)]
  Eigen::VectorXd coefficient;  ///< `n_c` [-]
  Eigen::VectorXd cohesion;     ///< `n_c` [sqrt(energy)]
  Eigen::MatrixXd rigid;        ///< `2 n_c x k`, orthonormal
  Eigen::VectorXd resultant;    ///< `k` [sqrt(energy)]
  Eigen::VectorXd scale;        ///< `2 n_c` s; force = s * scaled force, gap = scaled gap / s
  Eigen::MatrixXd inverse;      ///< `n_r x k`: amplitude = inverse * scaled amplitude
  /// A load along a motion that moves no pair `n_r`, as amplitudes, or empty
  Eigen::VectorXd loose;
};

/// Equilibrates a friction problem.
/// \param problem  F, d, s, mu, c, R, r
/// \return the scaled problem
/// \throws std::invalid_argument as check_problem()
[[nodiscard]] ScaledFriction equilibrate(const FrictionProblem& problem);

/// What numbers that need not solve anything say about each pair: it is closed if its force exceeds
/// its gap, and then slides if |tau - slip| exceeds the bound of the force less the gap.
///
/// At a solution all this is as it is said; elsewhere it is the guess of a projection.
/// \param problem   scaled
/// \param force     `2 n_c`
/// \param movement  `2 n_c` gaps, then slips
/// \param reach     forces count reach times against gaps and slips
/// \param[out] motions  `n_c`
/// \return how many entries of `motions` changed
Eigen::Index predict_motions(const ScaledFriction& problem, const Eigen::VectorXd& force,
                             const Eigen::VectorXd& movement, double reach,
                             std::vector<Motion>& motions);

/// Forces and movements for given motions, scaled.
struct FrictionClosure {
  Eigen::VectorXd force;      ///< `2 n_c`
  Eigen::VectorXd movement;   ///< `2 n_c` gaps, then slips; exactly 0 where the motion says so
  Eigen::VectorXd amplitude;  ///< `k`
  bool solvable = false;      ///< whether the equations hold to rounding
  bool confirmed = false;     ///< whether all signs are right too, beyond rounding
  /// Whether the determinant of the system has the sign that it cannot have with little friction.
  bool reversed = false;
};

/// Solves the equations of the motions, refined in twice the working precision: no gap of closed pairs,
/// no slip of sticking ones, tau = -b or b of sliding ones, R^T f = r.
///
/// If they are singular, as where gap rows repeat each other, the solution nearest to the start is
/// taken.
/// \param problem    scaled
/// \param motions    `n_c`
/// \param force      `2 n_c` where to start; what the motions fix is not looked at
/// \param amplitude  `k` where to start
/// \return forces, movements, amplitudes, and whether this is a solution
[[nodiscard]] FrictionClosure close_friction(const ScaledFriction& problem,
                                             const std::vector<Motion>& motions,
                                             const Eigen::VectorXd& force,
                                             const Eigen::VectorXd& amplitude);

/// Turns scaled numbers into a state of the original problem. A claim of `Solved` that its certificate
/// does not confirm becomes `Breakdown`.
/// \param problem  as it was posed
/// \param scaled   the same, equilibrated
/// \param closure  forces, movements and amplitudes
/// \param motions  `n_c`
/// \param report   how the solver got there
/// \param reason   why it is no solution, empty for one
/// \return the state
[[nodiscard]] FrictionState unscaled(const FrictionProblem& problem, const ScaledFriction& scaled,
                                     const FrictionClosure& closure,
                                     const std::vector<Motion>& motions, Report report,
                                     std::string reason);

}  // namespace signorini

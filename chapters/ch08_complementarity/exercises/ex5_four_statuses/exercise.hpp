/// \file
/// Exercise 8.5 - four statuses. Do not change this file.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace ex8_5 {

/// n pairs with friction, condensed: gap = d + rows 1 to n of G (lambda, tau), slip = s + the other rows.
struct Problem {
  Eigen::MatrixXd compliance;  ///< G `2 n x 2 n` [length/force]
  Eigen::VectorXd free_gap;    ///< d `n` [length], overlap < 0
  Eigen::VectorXd free_slip;   ///< s `n` [length], of the source along the tangent
  double mu;                   ///< friction coefficient, not negative
};

/// What a pair does.
enum class Status { Open, Stick, Forward, Backward };

/// Where a run ended.
struct Answer {
  Eigen::VectorXd force;         ///< lambda `n` [force]
  Eigen::VectorXd friction;      ///< tau `n` [force], on the source along the tangent
  std::vector<Status> statuses;  ///< of these forces
  int steps = 0;                 ///< linear systems that were solved
  bool solved = false;           ///< no status changed any more
};

/// What each pair does by lambda = max(0, lambda - c gap) and tau = P(tau - c slip), where P returns a number to the
/// interval from -B to B, and B = mu max(0, lambda - c gap).
/// \param problem   any \param c  > 0 [force/length]
/// \param force     lambda `n` \param friction  tau `n`
/// \return Open where lambda - c gap is not positive, else Stick where the trial value stays as it is
[[nodiscard]] std::vector<Status> statuses_at(const Problem& problem, double c,
                                              const Eigen::VectorXd& force,
                                              const Eigen::VectorXd& friction);

/// The forces that statuses stand for.
/// \param problem   any \param statuses  `n`
/// \return lambda and tau, one after the other `2 n`; not finite if the equations are singular
[[nodiscard]] Eigen::VectorXd forces_of(const Problem& problem,
                                        const std::vector<Status>& statuses);

/// Newton's method with whole steps, from no forces. \PaperEq{LinEtAl, 13} \PaperEq{LinEtAl, 14}
/// \param problem  any \param c  > 0 [force/length]
/// \return forces and statuses; `solved` is false if statuses come back that were there before, or forces are not finite
[[nodiscard]] Answer semismooth(const Problem& problem, double c);

}  // namespace ex8_5

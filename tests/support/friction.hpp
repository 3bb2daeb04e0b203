// Friction problems for the tests, and all solutions of a small one.
#pragma once
#include <vector>

#include "signorini/problem/active_set_system.hpp"
#include "support/random.hpp"

namespace signorini_test {

/// F = C C^T + 0.1 I with a random C, gaps of both signs, slips, coefficients up to `coefficient` and
/// cohesion up to `cohesion`.
signorini::ContactProblem random_friction(Random& random, Eigen::Index n, double coefficient,
                                          double cohesion = 0);

/// The same, free to move both ways, with a load that some forces within their bounds balance.
signorini::ContactProblem random_floating(Random& random, Eigen::Index n, double coefficient);

/// One pair.
signorini::ContactProblem one_pair(const Eigen::Matrix2d& F, double gap, double slip,
                                   double coefficient, double cohesion = 0);

/// The same problem where only some pairs rub.
/// \param problem  in which all pairs rub
/// \param pairs    those that still do, in increasing order
signorini::ContactProblem frictional_only(const signorini::ContactProblem& problem,
                                          const std::vector<Eigen::Index>& pairs);

/// The forces of all solutions, normal ones first: every choice of motions, tried one by one.
std::vector<Eigen::VectorXd> all_solutions(const signorini::ContactProblem& problem);

/// The forces of a state, normal ones first.
Eigen::VectorXd forces(const signorini::ContactState& state);

/// A rigid cylinder of radius 1 pressed by P on a half-plane with E* = 1 until it touches on |x| < 1, and
/// pushed along by Q = part * mu * P: n elements of constant traction on |x| < 1.3. Bodies alike, so that
/// pressure does not make them slide; free to move both ways.
signorini::ContactProblem cylinder(Eigen::Index n, double coefficient, double part);

}  // namespace signorini_test

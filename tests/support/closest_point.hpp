// The simplest contact problem: the point of a polyhedron that is closest to a given one.
#pragma once
#include <Eigen/Core>

#include "signorini/core/random.hpp"
#include "signorini/problem/problem.hpp"

namespace signorini_test {

/// The point closest to p with A u <= g: K = I.
struct ClosestPoint {
  Eigen::MatrixXd A;
  Eigen::VectorXd p;
  Eigen::VectorXd g;
  [[nodiscard]] signorini::ContactProblem problem() const { return {A * A.transpose(), g - A * p}; }
  [[nodiscard]] Eigen::VectorXd displacement(const signorini::ContactState& state) const {
    return p - A.transpose() * state.force;
  }
  [[nodiscard]] double energy(const Eigen::VectorXd& u) const { return 0.5 * u.dot(u) - p.dot(u); }
};

/// A point outside of eight half-spaces in small whole numbers. As g >= 0, they have u = 0 in common.
inline ClosestPoint eight_half_spaces(signorini::Random& random) {
  ClosestPoint made{Eigen::MatrixXd(8, 3), Eigen::VectorXd(3), Eigen::VectorXd(8)};
  do {
    for (double& a : made.A.reshaped()) a = random.whole(-3, 3);
    for (double& g : made.g) g = random.whole(0, 3);
    for (double& p : made.p) p = random.whole(-6, 6);
  } while (made.problem().free_gap.minCoeff() >= 0);
  return made;
}

}  // namespace signorini_test

// The simplest contact problem: the point of a polyhedron that is closest to a given one.
#pragma once
#include <Eigen/Core>

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

}  // namespace signorini_test

/// \file
/// The small problems that Newton's method is tried on.
#pragma once
#include <cmath>
#include <vector>

#include "signorini/problem/examples.hpp"
#include "signorini/problem/problem.hpp"

namespace signorini {

/// A stretched string that sags onto a rigid wave: n pairs that all act on each other.
inline ContactProblem string_over_wave(Eigen::Index n) {
  ContactProblem string{Eigen::MatrixXd(n, n), Eigen::VectorXd(n)};
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(n + 2, 0, 1).segment(1, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    string.free_gap(i) = std::cos(9 * x(i)) - 0.2;
    for (Eigen::Index j = 0; j < n; ++j)
      string.compliance(i, j) = std::min(x(i), x(j)) * (1 - std::max(x(i), x(j)));
  }
  return string;
}

struct Named {
  const char* name;
  ContactProblem problem;
};

// [problems]
inline const std::vector<Named> problems = {
    {"one pair", {Eigen::MatrixXd::Ones(1, 1), -Eigen::VectorXd::Ones(1)}},
    {"touching", {(Eigen::Matrix2d() << 2, 1, 1, 2).finished(), Eigen::Vector2d(-2, -1)}},
    {"in a circle",
     {(Eigen::Matrix3d() << 4, -6, -4, -6, 10, 8, -4, 8, 9).finished(),
      Eigen::Vector3d(3, -4, -1)}},
    {"string", string_over_wave(40)},
    {"half-plane", half_plane_indentation(40).problem}};
// [problems]

/// The half-plane, dragged along by a shift of the punch with mu = 0.3. A half-plane that does not change its
/// volume gives way along its surface as it does across it, and the two do not mix.
// [sheared]
inline ContactProblem sheared(double shift) {
  const ContactProblem pressed = half_plane_indentation(40).problem;
  const Eigen::Index n = pressed.free_gap.size();
  ContactProblem problem{Eigen::MatrixXd::Zero(2 * n, 2 * n), pressed.free_gap,
                         Eigen::VectorXd::Constant(n, shift),
                         law_of_all(Eigen::VectorXd::Constant(n, 0.3), Eigen::VectorXd::Zero(n))};
  problem.compliance.topLeftCorner(n, n) = pressed.compliance;
  problem.compliance.bottomRightCorner(n, n) = pressed.compliance;
  return problem;
}
// [sheared]

/// A rigid cylinder, R = 50 mm, pressed into a half-plane until 2.16 mm of it touch: 40 pairs on 3.6 mm, in
/// mm and N per mm of thickness.
inline ContactProblem pressed_cylinder() {
  const double stiffness = 4000 / (1 - 0.35 * 0.35);  // E / (1 - nu^2) [N/mm^2]
  ContactProblem problem = half_plane_indentation(40).problem;
  problem.compliance /= stiffness;
  problem.free_gap *= 1.8 * 1.8 / 50;
  return problem;
}

}  // namespace signorini

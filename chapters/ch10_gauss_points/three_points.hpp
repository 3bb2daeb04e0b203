// Three Gauss points between two nodes, each of them a spring, and friction: two solutions.
#pragma once
#include <cmath>

#include "signorini/problem/problem.hpp"

namespace ch10 {

using namespace signorini;

struct ThreePoints {
  ContactProblem problem;     ///< of the points
  ContactProblem nodes;       ///< of forces at the nodes instead
  ContactState stick, slide;  ///< two solutions of the first
};

// [three points]
inline ThreePoints three_points() {
  ThreePoints on;
  const double xi = std::sqrt(0.6), free_slip = 0.2;
  Eigen::MatrixXd B(2, 3);  // what the nodes receive of the points
  B << (1 + xi) / 2, 0.5, (1 - xi) / 2, (1 - xi) / 2, 0.5, (1 + xi) / 2;
  on.nodes.compliance = Eigen::MatrixXd::Identity(4, 4);
  on.nodes.free_gap = Eigen::Vector2d(-1, -1);
  on.nodes.free_slip = Eigen::Vector2d(-free_slip, free_slip);  // pulled apart
  on.nodes.law = law_of_all(Eigen::Vector2d(0.3, 0.3), Eigen::Vector2d(0, 0));
  on.problem = on.nodes;
  on.problem.compliance = Eigen::MatrixXd::Zero(6, 6);
  on.problem.compliance.topLeftCorner(3, 3) = B.transpose() * B;
  on.problem.compliance.bottomRightCorner(3, 3) = B.transpose() * B;
  on.problem.free_gap = B.transpose() * on.nodes.free_gap;
  on.problem.free_slip = B.transpose() * on.nodes.free_slip;
  on.problem.law = law_of_all(Eigen::Vector3d(0.3, 0.3, 0.3), Eigen::Vector3d(0, 0, 0));
  on.stick.force = Eigen::Vector3d(1, 0, 1);
  on.stick.friction = Eigen::Vector3d(free_slip / xi, 0, -free_slip / xi);
  on.slide.force = Eigen::Vector3d(0, 2, 0);
  on.slide.friction = Eigen::Vector3d(0, 0, 0);
  for (ContactState* state : {&on.stick, &on.slide}) {
    state->gap = on.problem.free_gap + B.transpose() * (B * state->force);
    state->slip = on.problem.free_slip + B.transpose() * (B * state->friction);
  }
  return on;
}
// [three points]

}  // namespace ch10

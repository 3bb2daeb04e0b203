// Chapter 22 - One node between a spring and a bowl, with the turning of the normal or without.
#pragma once
#include <Eigen/LU>
#include <algorithm>

#include "signorini/contact/obstacle.hpp"

namespace ch22 {

using Eigen::Matrix2d;
using Eigen::Vector2d;

const double radius = 1;     // of the bowl [mm]
const double stiffness = 1;  // of the spring, the same in all directions [N/mm]

/// Where the node is, and what the bowl does to it.
struct Node {
  Vector2d u;    // from the end of the spring [mm]
  double force;  // of contact [N]
};

// [turning]
/// One iteration: the exact answer of a linear contact problem.
/// \param now     where it begins \param weight  that presses the node down [N]
/// \param turns   whether the normal turns within the iteration
inline Node next(const Node& now, double weight, bool turns) {
  static const signorini::Obstacle bowl = signorini::hole({0, 0}, radius);
  const Vector2d rest(0.3, -0.9);
  const auto [gap, n] = bowl.look(rest + now.u);
  Matrix2d K = stiffness * Matrix2d::Identity();
  if (turns) K += now.force / (radius - gap) * (Matrix2d::Identity() - n * n.transpose());
  const Vector2d free = K.inverse() * (Vector2d(0, -weight) - stiffness * now.u);
  const Vector2d pushed = K.inverse() * n;
  const double force = std::max(0.0, -(gap + n.dot(free)) / n.dot(pushed));
  return {now.u + free + force * pushed, force};
}
// [turning]

}  // namespace ch22

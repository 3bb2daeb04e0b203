// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What vectors of the plane have that others have not.
#pragma once
#include <Eigen/Core>

namespace signorini {

/// \param a  a vector in the plane
/// \param b  another
/// \return a_x b_y - a_y b_x: the moment of a force b with the arm a, positive counter-clockwise
[[nodiscard]] inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace signorini

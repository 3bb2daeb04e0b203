/// \file
/// Exercise 0.1 - the element. Do not change this file.
#pragma once
#include <Eigen/Core>

namespace ex0_1 {

/// The stiffness matrix of a triangle of three nodes.
/// \param corners    positions, anticlockwise [length]
/// \param D          of sigma = D epsilon, with epsilon = (xx, yy, 2 xy) [force/length^2]
/// \param thickness  across the plane [length]
/// \return K; x, y of the first corner, then of the second, ... [force/length]
/// \throws std::invalid_argument unless the corners run anticlockwise around an area, the thickness is positive, and
///   all positions are finite
[[nodiscard]] Eigen::Matrix<double, 6, 6> triangle_stiffness(
    const Eigen::Matrix<double, 3, 2>& corners, const Eigen::Matrix3d& D, double thickness);

}  // namespace ex0_1

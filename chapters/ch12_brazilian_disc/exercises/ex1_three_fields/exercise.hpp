/// \file
/// Exercise 12.1 - a disc between two line loads, from three fields. Do not change this file.
#pragma once
#include <Eigen/Core>

namespace ex12_1 {

/// Stress of a half-plane under a force on its edge.
/// \param force      P, per thickness [force/length]
/// \param foot       where the force acts [length]
/// \param direction  of the force, into the half-plane; a unit vector
/// \param at         point of the half-plane [length]
/// \return (xx, yy, xy), tension > 0 [force/length^2]
/// \throws std::invalid_argument if the point is the foot or not in the half-plane, that is above its
///   edge; points of the edge are allowed and free of stress
[[nodiscard]] Eigen::Vector3d line_load_stress(double force, const Eigen::Vector2d& foot,
                                               const Eigen::Vector2d& direction,
                                               const Eigen::Vector2d& at);

/// Stress of a disc about the origin, squeezed by two opposite forces.
/// \param radius  R [length]
/// \param force   P, per thickness [force/length]
/// \param angle   of the first load from the y axis, counted towards the x axis [rad]; the other load
///   is opposite
/// \param at      point of the disc [length]
/// \return (xx, yy, xy), tension > 0 [force/length^2]
/// \throws std::invalid_argument unless radius and force are positive, if the point is outside of the
///   disc by more than 1e-12 of the radius, or under a load
[[nodiscard]] Eigen::Vector3d disc_stress(double radius, double force, double angle,
                                          const Eigen::Vector2d& at);

}  // namespace ex12_1

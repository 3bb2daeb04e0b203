/// \file
/// Exercise 13.2 - a rigid footing under a load beside its middle. Do not change this file.
#pragma once
#include <Eigen/Core>

namespace ex13_2 {

/// How a rigid footing comes to rest.
struct Rest {
  Eigen::VectorXd
      force;  ///< `n` of the points [force], compression > 0, exactly 0 where it has lifted off
  double settlement = 0;  ///< of the point x = 0 of the footing, downwards [length]
  double tilt = 0;        ///< angle [rad], > 0 if the side of positive x goes down
};

/// Finds the rest of a rigid footing that stands on points of an elastic ground without friction.
///
/// The underside of the footing is straight and lies on the points before loading. It sinks by
/// settlement + tilt * x; points of the ground under it sink at least as far, and those that sink further
/// carry nothing. The ground answers forces F with the settlements G F.
/// \param compliance    G `n x n` of the points [length/force], symmetric and positive definite
/// \param position      x `n` of the points [length], at least two different ones
/// \param load          P on the footing, downwards [force], > 0
/// \param eccentricity  e: the load acts at x = e [length], between the outermost points
/// \return forces that balance the load and its moment, settlement and tilt
/// \throws std::invalid_argument unless there is a position per row of G
/// \throws signorini::NotSolved if the load acts beside all points: the footing topples
[[nodiscard]] Rest come_to_rest(const Eigen::MatrixXd& compliance, const Eigen::VectorXd& position,
                                double load, double eccentricity);

}  // namespace ex13_2

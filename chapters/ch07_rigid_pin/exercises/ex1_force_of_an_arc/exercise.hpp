/// \file
/// Exercise 7.1 - the force of a pressure over an arc. Do not change this file.
#pragma once
#include <Eigen/Core>

namespace ex7_1 {

/// Force on the plate of a pressure on the edge of its hole.
///
/// At the angle t from the pole the pressure pushes along (cos t, sin t): the first component towards the
/// pole, the second across. It is linear in the angle between the given angles and zero outside. The
/// result is exact but for rounding, relative to the sum of the magnitudes of the pressures' forces, also
/// for angles that nearly agree.
/// \param angle      `n` >= 2 from the pole, increasing [rad]
/// \param pressure   `n` at these angles [force/length^2]
/// \param radius     of the hole [length], positive
/// \param thickness  of the plate [length], positive
/// \return force towards the pole and across [force]
/// \throws std::invalid_argument if sizes differ, there are fewer than two angles, they do not increase,
///   or radius or thickness is not positive
[[nodiscard]] Eigen::Vector2d arc_force(const Eigen::VectorXd& angle,
                                        const Eigen::VectorXd& pressure, double radius,
                                        double thickness);

}  // namespace ex7_1

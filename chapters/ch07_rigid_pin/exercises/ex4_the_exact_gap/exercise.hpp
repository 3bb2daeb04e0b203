/// \file
/// Exercise 7.4 - the exact gap. Do not change this file.
#pragma once

namespace ex7_4 {

/// A round pin in a round hole about the origin.
struct Fit {
  double hole_radius;  ///< R [length], > 0
  double
      clearance;  ///< epsilon: radius of the hole less radius of the pin [length], < R; < 0 for a thicker pin
  double shift;  ///< s: the middle of the pin is at (s, 0) [length], |s| < R
};

/// Between a point of the hole and the pin.
struct Gap {
  double gap;     ///< open > 0, overlap < 0 [length]
  double nx, ny;  ///< unit normal out of the pin, towards the plate [-]
};

/// Distance of the point of the hole at R (cos theta, sin theta) from the pin.
/// \param fit    the two circles
/// \param theta  from the pole, which is at (R, 0) [rad]
/// \return gap, to a few units in the last digit of the largest of |epsilon - s|, s theta^2 and s^2 / R, as far as theta is below 1; normal
/// \throws std::invalid_argument if a number is not finite, R is not positive, epsilon is not below R or |s| not below R
[[nodiscard]] Gap gap_at(const Fit& fit, double theta);

}  // namespace ex7_4

/// \file
/// Exercise 7.2 - the contact angle of a pin from clearance and load. Do not change this file.
#pragma once

namespace ex7_2 {

/// What was found and how.
struct ContactAngle {
  double angle;     ///< half of the arc in contact [rad], above 0, at most pi
  int evaluations;  ///< of the load relation, derivatives not counted
};

/// Solves the load relation of a pin in an infinite plate, with b = tan(angle / 2):
/// (1 - r (ln(1 + b^2) + 2 b^4)) / (pi b^2 (1 + b^2)) = wanted.
/// \param wanted           E* Delta R / P [-], any finite number; negative if the pin is thicker than the
///                         hole
/// \param stiffness_ratio  r = E* / E_h [-], positive: 1 for a rigid pin, 1/2 for equal materials
/// \return the root, to 1e-12 of itself, after at most 200 evaluations; pi if `wanted` is -2 r / pi or
///   less, which the relation does not reach: the pin touches all round
/// \throws std::invalid_argument if `wanted` is not finite or the ratio is not positive
[[nodiscard]] ContactAngle half_contact_angle(double wanted, double stiffness_ratio);

}  // namespace ex7_2

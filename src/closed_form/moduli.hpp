/// \file
/// Elastic constants as plane problems see them.
#pragma once

namespace signorini {

/// Modulus of a plane body that cannot strain across the plane.
/// \param youngs_modulus  E [force/length^2]
/// \param poisson_ratio   nu [-]
/// \return E / (1 - nu^2) [force/length^2]; in plane stress use E itself
[[nodiscard]] inline double plane_strain_modulus(double youngs_modulus, double poisson_ratio) {
  return youngs_modulus / (1 - poisson_ratio * poisson_ratio);
}

/// Poisson's ratio of a plane body that cannot strain across the plane.
/// \param poisson_ratio  nu [-], below 1
/// \return nu / (1 - nu) [-]; in plane stress use nu itself
[[nodiscard]] inline double plane_strain_ratio(double poisson_ratio) {
  return poisson_ratio / (1 - poisson_ratio);
}

/// Modulus E* of two bodies in contact, \f$ 1 / E^{*} = 1 / E'_1 + 1 / E'_2 \f$.
/// \param first   E' of one body, plane_strain_modulus() or E in plane stress [force/length^2]
/// \param second  E' of the other; against a rigid body E* is the first alone [force/length^2]
/// \return E* [force/length^2]
[[nodiscard]] inline double contact_modulus(double first, double second) {
  return first * second / (first + second);
}

}  // namespace signorini

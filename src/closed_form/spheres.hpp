// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Thick hollow spheres under pressure, and two spheres pressed together.
#pragma once
#include "closed_form/rings.hpp"

namespace signorini {

/// A hollow sphere, or a full one if its inner radius is 0.
struct HollowSphere {
  double inner_radius;    ///< [length], not negative
  double outer_radius;    ///< [length], larger
  double youngs_modulus;  ///< E [force/length^2], > 0
  double poisson_ratio;   ///< nu [-]
};

/// Stress of a hollow sphere a < r < b, after Lame [\ref TimoshenkoGoodier1970]:
/// \f[ \sigma_r = A - B / r^3,\ \sigma_\theta = A + B / (2 r^3),\quad
///     A = \frac{p_i a^3 - p_o b^3}{b^3 - a^3},\quad B = \frac{(p_i - p_o)\,a^3 b^3}{b^3 - a^3}. \f]
/// \param sphere  any
/// \param load    pressures inside and outside
/// \param r       from the centre [length], in the sphere
/// \return radial stress, and the one in both directions across the radius
/// \throws std::invalid_argument if radii or modulus are out of range, or r outside of the sphere
[[nodiscard]] RingStress sphere_stress(const HollowSphere& sphere, const RingPressure& load,
                                       double r);

/// Displacement of a hollow sphere, \f$ u = r\,[(1 - \nu)\,\sigma_\theta - \nu\,\sigma_r] / E \f$.
/// \param sphere  any
/// \param load    pressures inside and outside
/// \param r       from the centre [length], in the sphere
/// \return u outwards [length]
/// \throws std::invalid_argument as sphere_stress()
[[nodiscard]] double sphere_displacement(const HollowSphere& sphere, const RingPressure& load,
                                         double r);

/// Two spheres, or a sphere and a plane, pressed together at a point, without friction: the theory of Hertz, as in
/// Johnson [\ref Johnson1985], chapter 4. Surfaces are half-spaces as long as the contact is small against the radius.
struct PointContact {
  double radius;   ///< R, 1/R = 1/R_1 + 1/R_2; a plane has 1/R_2 = 0 [length], > 0
  double modulus;  ///< E* as contact_modulus() [force/length^2], > 0
  double force;    ///< P [force], > 0
};

/// Radius of the circle of contact, \f$ a = \sqrt[3]{3 P R / (4 E^{*})} \f$.
/// \param contact  with its load
/// \return a [length]
/// \throws std::invalid_argument unless radius, modulus and force are positive
[[nodiscard]] double hertz_radius(const PointContact& contact);

/// Largest pressure, \f$ p_0 = 3 P / (2 \pi a^2) \f$; at r it is \f$ p_0 \sqrt{1 - r^2 / a^2} \f$.
/// \param contact  with its load
/// \return p_0 in the middle of the contact [force/length^2], compression > 0
/// \throws std::invalid_argument as hertz_radius()
[[nodiscard]] double hertz_peak_pressure(const PointContact& contact);

/// How far two distant points of the bodies approach each other, \f$ \delta = a^2 / R \f$.
/// \param contact  with its load
/// \return approach [length]
/// \throws std::invalid_argument as hertz_radius()
[[nodiscard]] double hertz_approach(const PointContact& contact);

}  // namespace signorini

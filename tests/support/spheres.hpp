/// \file
/// Thick hollow spheres under pressure, and two spheres pressed together.
#pragma once
#include <cmath>

#include "closed_form/rings.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini_test {

/// A hollow sphere, or a full one if its inner radius is 0.
struct HollowSphere {
  double inner_radius;    ///< [length], not negative
  double outer_radius;    ///< [length], larger
  double youngs_modulus;  ///< E [force/length^2], > 0
  double poisson_ratio;   ///< nu [-]
};

/// Stress of a hollow sphere a < r < b, after Lame [TimoshenkoGoodier1970]:
/// \f[ \sigma_r = A - B / r^3,\ \sigma_\theta = A + B / (2 r^3),\quad
///     A = \frac{p_i a^3 - p_o b^3}{b^3 - a^3},\quad B = \frac{(p_i - p_o)\,a^3 b^3}{b^3 - a^3}. \f]
/// \param sphere  any
/// \param load    pressures inside and outside
/// \param r       from the centre [length], in the sphere
/// \return radial stress, and the one in both directions across the radius
/// \throws std::invalid_argument if radii or modulus are out of range, or r outside of the sphere
inline signorini::RingStress sphere_stress(const HollowSphere& sphere,
                                           const signorini::RingPressure& load, double r) {
  const double a = sphere.inner_radius;
  const double b = sphere.outer_radius;
  signorini::require_argument(a >= 0 && b > a && sphere.youngs_modulus > 0,
                              "sphere: need 0 <= inner < outer radius and a positive modulus, got ",
                              a, ", ", b, ", ", sphere.youngs_modulus);
  signorini::require_argument(r >= a * (1 - 1e-12) && r <= b * (1 + 1e-12) && (r > 0 || a == 0),
                              "sphere from ", a, " to ", b, ": no radius ", r);
  const double volume = (b - a) * (b * b + a * b + a * a);
  const double A = (load.inside * a * a * a - load.outside * b * b * b) / volume;
  const double B = (load.inside - load.outside) * a * a * a * b * b * b / volume;
  const double bulge = B == 0 ? 0 : B / (r * r * r);
  return {A - bulge, A + bulge / 2};
}

/// Displacement of a hollow sphere, \f$ u = r\,[(1 - \nu)\,\sigma_\theta - \nu\,\sigma_r] / E \f$.
/// \param sphere  any
/// \param load    pressures inside and outside
/// \param r       from the centre [length], in the sphere
/// \return u outwards [length]
/// \throws std::invalid_argument as sphere_stress()
inline double sphere_displacement(const HollowSphere& sphere, const signorini::RingPressure& load,
                                  double r) {
  const signorini::RingStress stress = sphere_stress(sphere, load, r);
  const double nu = sphere.poisson_ratio;
  return r * ((1 - nu) * stress.hoop - nu * stress.radial) / sphere.youngs_modulus;
}

/// Two spheres, or a sphere and a plane, pressed together at a point, without friction: the theory of Hertz, as in
/// Johnson [Johnson1985], chapter 4. Surfaces are half-spaces as long as the contact is small against the radius.
struct PointContact {
  double radius;   ///< R, 1/R = 1/R_1 + 1/R_2; a plane has 1/R_2 = 0 [length], > 0
  double modulus;  ///< E* as contact_modulus() [force/length^2], > 0
  double force;    ///< P [force], > 0
};

/// Radius of the circle of contact, \f$ a = \sqrt[3]{3 P R / (4 E^{*})} \f$.
/// \param contact  with its load
/// \return a [length]
/// \throws std::invalid_argument unless radius, modulus and force are positive
inline double hertz_radius(const PointContact& contact) {
  signorini::require_argument(contact.radius > 0 && contact.modulus > 0 && contact.force > 0,
                              "point contact: radius, modulus and force must be positive, got ",
                              contact.radius, ", ", contact.modulus, ", ", contact.force);
  return std::cbrt(3 * contact.force * contact.radius / (4 * contact.modulus));
}

/// Largest pressure, \f$ p_0 = 3 P / (2 \pi a^2) \f$; at r it is \f$ p_0 \sqrt{1 - r^2 / a^2} \f$.
/// \param contact  with its load
/// \return p_0 in the middle of the contact [force/length^2], compression > 0
/// \throws std::invalid_argument as hertz_radius()
inline double hertz_peak_pressure(const PointContact& contact) {
  const double a = hertz_radius(contact);
  return 3 * contact.force / (2 * signorini::pi * a * a);
}

/// How far two distant points of the bodies approach each other, \f$ \delta = a^2 / R \f$.
/// \param contact  with its load
/// \return approach [length]
/// \throws std::invalid_argument as hertz_radius()
inline double hertz_approach(const PointContact& contact) {
  const double a = hertz_radius(contact);
  return a * a / contact.radius;
}

}  // namespace signorini_test

#include "closed_form/spheres.hpp"

#include <cmath>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {

RingStress sphere_stress(const HollowSphere& sphere, const RingPressure& load, double r) {
  const double a = sphere.inner_radius;
  const double b = sphere.outer_radius;
  require_argument(a >= 0 && b > a && sphere.youngs_modulus > 0,
                   "sphere: need 0 <= inner < outer radius and a positive modulus, got ", a, ", ",
                   b, ", ", sphere.youngs_modulus);
  require_argument(r >= a * (1 - 1e-12) && r <= b * (1 + 1e-12) && (r > 0 || a == 0),
                   "sphere from ", a, " to ", b, ": no radius ", r);
  const double volume = (b - a) * (b * b + a * b + a * a);
  const double A = (load.inside * a * a * a - load.outside * b * b * b) / volume;
  const double B = (load.inside - load.outside) * a * a * a * b * b * b / volume;
  const double bulge = B == 0 ? 0 : B / (r * r * r);
  return {A - bulge, A + bulge / 2};
}

double sphere_displacement(const HollowSphere& sphere, const RingPressure& load, double r) {
  const RingStress stress = sphere_stress(sphere, load, r);
  const double nu = sphere.poisson_ratio;
  return r * ((1 - nu) * stress.hoop - nu * stress.radial) / sphere.youngs_modulus;
}

double hertz_radius(const PointContact& contact) {
  require_argument(contact.radius > 0 && contact.modulus > 0 && contact.force > 0,
                   "point contact: radius, modulus and force must be positive, got ",
                   contact.radius, ", ", contact.modulus, ", ", contact.force);
  return std::cbrt(3 * contact.force * contact.radius / (4 * contact.modulus));
}

double hertz_peak_pressure(const PointContact& contact) {
  const double a = hertz_radius(contact);
  return 3 * contact.force / (2 * pi * a * a);
}

double hertz_approach(const PointContact& contact) {
  const double a = hertz_radius(contact);
  return a * a / contact.radius;
}

}  // namespace signorini

#include <algorithm>

#include "exercise.hpp"
#include "signorini/core/errors.hpp"

namespace ex14_2 {

FitStress press_fit(const Fit& fit) {
  const double a = fit.bore, b = fit.radius, d = fit.outside;
  signorini::require_argument(
      0 <= a && a < b && b < d && fit.shaft_modulus > 0 && fit.hub_modulus > 0,
      "press_fit: need 0 <= bore < radius < outside and positive moduli, got ", a, ", ", b, ", ", d,
      " and ", fit.shaft_modulus, ", ", fit.hub_modulus);
  const double hub = (d * d + b * b) / (d * d - b * b);    // hoop stress per pressure at b
  const double shaft = (b * b + a * a) / (b * b - a * a);  // its magnitude in the shaft at b
  const double widens = b * (hub + fit.hub_ratio) / fit.hub_modulus;
  const double narrows = b * (shaft - fit.shaft_ratio) / fit.shaft_modulus;
  const double pressure = std::max(0.0, fit.interference / (widens + narrows));
  // A bore doubles the stress in the middle of a solid shaft, however small it is.
  const double middle = a == 0 ? 1 : 2 * b * b / (b * b - a * a);
  return {pressure, pressure * hub, -pressure * middle};
}

}  // namespace ex14_2

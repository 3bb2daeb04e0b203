#include "closed_form/pin.hpp"

#include <cmath>

#include "signorini/core/bisection.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {

double pin_clearance_over_load(double half_angle, double stiffness_ratio) {
  require_argument(
      half_angle > 0 && half_angle < pi && stiffness_ratio > 0,
      "pin: need a contact angle between 0 and pi and a positive ratio of moduli, got ", half_angle,
      " and ", stiffness_ratio);
  const double b = std::tan(half_angle / 2);
  const double b2 = b * b;
  return (1 - stiffness_ratio * (std::log1p(b2) + 2 * b2 * b2)) / (pi * b2 * (1 + b2));
}

double pin_contact_angle(const PinInPlate& pin) {
  require_argument(pin.hole_radius > 0 && pin.force > 0 && pin.plate_modulus > 0 &&
                       pin.contact_modulus > 0 && pin.clearance >= 0,
                   "pin: radius, force and moduli must be positive and the clearance not negative");
  const double wanted = pin.contact_modulus * pin.clearance / pin.force;
  const double ratio = pin.contact_modulus / pin.plate_modulus;
  const auto touches = [&](double angle) { return pin_clearance_over_load(angle, ratio) > wanted; };
  return bisected(0, pi, touches).first;  // the relation falls from infinity below zero
}

double pin_pressure(const PinInPlate& pin, double theta) {
  const double half_angle = pin_contact_angle(pin);
  if (std::abs(theta) >= half_angle) return 0;
  const double b2 = std::pow(std::tan(half_angle / 2), 2);
  const double y2 = std::pow(std::tan(theta / 2), 2);
  const double outer = std::sqrt(1 + b2);
  const double inner = std::sqrt(b2 - y2);
  const double pi_b = pi * b2 * (1 + b2);
  // ln((o + i) / (o - i)) = 2 artanh(i / o)
  return pin.force / pin.hole_radius *
         (2 / pi * inner / (outer * (1 + y2)) + std::atanh(inner / outer) / pi_b);
}

}  // namespace signorini

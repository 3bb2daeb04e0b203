#include "closed_form/hertz.hpp"

#include <algorithm>
#include <cmath>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

void check(const LineContact& contact) {
  require_argument(contact.radius > 0 && contact.modulus > 0 && contact.force > 0,
                   "line contact: radius, modulus and force must be positive, got ", contact.radius,
                   ", ", contact.modulus, ", ", contact.force);
}

}  // namespace

double hertz_half_width(const LineContact& contact) {
  check(contact);
  return std::sqrt(4 * contact.force * contact.radius / (pi * contact.modulus));
}

double hertz_peak_pressure(const LineContact& contact) {
  check(contact);
  return std::sqrt(contact.force * contact.modulus / (pi * contact.radius));
}

double hertz_pressure(const LineContact& contact, double x) {
  const double X = x / hertz_half_width(contact);
  return hertz_peak_pressure(contact) * std::sqrt(std::max(0.0, 1 - X * X));
}

Eigen::Vector3d hertz_stress(const LineContact& contact, double x, double depth) {
  require_argument(depth >= 0, "line contact: depth must not be negative, got ", depth);
  const double b = hertz_half_width(contact);
  const double X = x / b;
  const double z = depth / b;
  // (X + i z)^2 - 1 has the modulus r; the smaller of m and n comes from their product |X| z.
  const double s = 1 - X * X + z * z;
  const double r = std::hypot(s, 2 * X * z);
  const double larger = std::sqrt((r + std::abs(s)) / 2);
  if (larger == 0) return Eigen::Vector3d::Zero();  // the edge of the contact
  const double smaller = std::abs(X) * z / larger;
  const double m = s >= 0 ? larger : smaller;
  const double n = std::copysign(s >= 0 ? smaller : larger, x);
  const double share = (z * z + n * n) / r;  // r = m^2 + n^2
  const double q0 = hertz_peak_pressure(contact);
  return {-q0 * (m * (1 + share) - 2 * z), -q0 * m * (1 - share), q0 * n * (m * m - z * z) / r};
}

LargestShear hertz_largest_shear(const LineContact& contact) {
  const double golden = (std::sqrt(5.0) - 1) / 2;
  return {hertz_half_width(contact) * std::sqrt(golden),
          hertz_peak_pressure(contact) * golden * golden * std::sqrt(golden)};
}

double disc_approach(const LineContact& contact, double modulus, double radius) {
  require_argument(modulus > 0 && radius > 0, "disc: modulus and radius must be positive, got ",
                   modulus, " and ", radius);
  const double b = hertz_half_width(contact);
  return contact.force / (pi * modulus) * (2 * std::log(4 * radius / b) - 1);
}

}  // namespace signorini

#include "closed_form/cattaneo.hpp"

#include <algorithm>
#include <cmath>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

/// sqrt(max(0, 1 - x^2 / b^2)) - (c / b) sqrt(max(0, 1 - x^2 / c^2))
double shape(double b, double c, double x) {
  const auto root = [&](double reach) {
    return std::sqrt(std::max(0.0, (reach - x) * (reach + x))) / b;
  };
  return root(b) - root(c);
}

}  // namespace

double slip_limit(const PartialSlip& slip) {
  require_argument(
      slip.half_width > 0 && slip.peak_pressure > 0 && slip.friction_coefficient > 0,
      "partial slip: half-width, pressure and friction coefficient must be positive, got ",
      slip.half_width, ", ", slip.peak_pressure, ", ", slip.friction_coefficient);
  return slip.friction_coefficient * pi * slip.half_width * slip.peak_pressure / 2;
}

double stick_half_width(const PartialSlip& slip, double force) {
  const double limit = slip_limit(slip);
  require_argument(std::abs(force) <= limit, "partial slip: the force ", force,
                   " is beyond the limit ", limit, ", nothing holds it");
  return slip.half_width * std::sqrt(1 - std::abs(force) / limit);
}

double slip_traction(const PartialSlip& slip, double force, double x) {
  const double c = stick_half_width(slip, force);
  return std::copysign(slip.friction_coefficient * slip.peak_pressure, force) *
         shape(slip.half_width, c, x);
}

double slip_traction_back(const PartialSlip& slip, double turned, double force, double x) {
  require_argument(turned >= 0 && std::abs(force) <= turned, "partial slip: the force ", force,
                   " must lie between minus and plus ", turned, ", where it turned");
  const double c = stick_half_width(slip, (turned - force) / 2);
  return slip_traction(slip, turned, x) -
         2 * slip.friction_coefficient * slip.peak_pressure * shape(slip.half_width, c, x);
}

}  // namespace signorini

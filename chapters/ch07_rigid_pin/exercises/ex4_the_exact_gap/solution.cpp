#include <cmath>
#include <stdexcept>

#include "exercise.hpp"

namespace ex7_4 {

Gap gap_at(const Fit& fit, double theta) {
  const double R = fit.hole_radius, s = fit.shift, pin = R - fit.clearance;
  if (!std::isfinite(R) || !std::isfinite(s) || !std::isfinite(pin) || !std::isfinite(theta))
    throw std::invalid_argument("gap_at: a number is not finite");
  if (!(R > 0) || !(pin > 0)) throw std::invalid_argument("gap_at: a radius is not positive");
  if (!(std::abs(s) < R)) throw std::invalid_argument("gap_at: the shift is not below the radius");
  const double x = R * std::cos(theta) - s, y = R * std::sin(theta);
  const double distance = std::hypot(x, y);
  // distance^2 - pin^2 = 2 R (epsilon - s cos theta) + (s - epsilon)(s + epsilon)
  const double half = std::sin(theta / 2);
  const double apart = fit.clearance - s;
  const double squares = 2 * R * (apart + 2 * s * half * half) - apart * (s + fit.clearance);
  return {squares / (distance + pin), x / distance, y / distance};
}

}  // namespace ex7_4

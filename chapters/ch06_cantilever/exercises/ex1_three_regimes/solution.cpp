#include <cmath>

#include "exercise.hpp"
#include "signorini/core/errors.hpp"

namespace ex6_1 {

FoundationContact touch_foundation(const Cantilever& beam) {
  const double l = beam.length;
  const double w = beam.load;
  const double bending = beam.bending_stiffness;
  signorini::require_argument(
      l > 0 && bending > 0 && beam.gap >= 0,
      "touch_foundation: length and stiffness must be positive and the gap not "
      "negative, got ",
      l, ", ", bending, " and ", beam.gap);
  const double tip_load = 8 * bending * beam.gap / (l * l * l * l);  // w l^4 / 8EI = g
  const double line_load = 9 * tip_load;                             // the slope at the tip is 0
  if (w <= tip_load) return {l, 0, 0};
  if (w <= line_load) {
    // The tip stays at g: w l^4 / 8EI - R l^3 / 3EI = g.
    const double R = 3 * w * l / 8 - 3 * bending * beam.gap / (l * l * l);
    return {l, R, R};
  }
  // Left of s the beam is a cantilever of length s with a force R at its end. Slope 0 there gives
  // R = w s / 3, deflection g then gives w s^4 / 72EI = g. Right of s the pressure carries the load.
  const double s = std::pow(72 * bending * beam.gap / w, 0.25);
  const double R = w * s / 3;
  return {s, R, R + w * (l - s)};
}

}  // namespace ex6_1

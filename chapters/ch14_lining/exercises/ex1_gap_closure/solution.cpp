#include <algorithm>

#include "exercise.hpp"
#include "signorini/core/errors.hpp"

namespace ex14_1 {

namespace {

// Displacement at r of a ring a < r < b under the pressures inside and outside.
double displacement(const TwoRings& rings, double a, double b, double inside, double outside,
                    double r) {
  const double nu = rings.poisson_ratio;
  const double modulus = rings.youngs_modulus / (1 - nu * nu);
  const double ratio = nu / (1 - nu);
  const double area = (b - a) * (b + a);
  const double A = (inside * a * a - outside * b * b) / area;
  const double B = (inside - outside) * a * a * b * b / area;
  return ((1 - ratio) * A * r + (1 + ratio) * B / r) / modulus;
}

}  // namespace

Closure press_lining(const TwoRings& rings, double pressure) {
  const auto [a, b, c, d, E, nu] = rings;
  signorini::require_argument(
      0 < a && a < b && b <= c && c < d && pressure >= 0,
      "press_lining: radii must grow from a > 0 to d and the pressure must not be "
      "negative, got ",
      a, ", ", b, ", ", c, ", ", d, " and ", pressure);
  const double opens = displacement(rings, a, b, 1, 0, b);     // rim b per pressure inside
  const double back = -displacement(rings, a, b, 0, 1, b);     // rim b per pressure on it
  const double away = displacement(rings, c, d, b / c, 0, c);  // rim c per pressure on b
  const double closing = (c - b) / opens;
  const double contact = std::max(0.0, opens * (pressure - closing) / (back + away));
  return {closing, contact, displacement(rings, a, b, pressure, contact, a)};
}

}  // namespace ex14_1

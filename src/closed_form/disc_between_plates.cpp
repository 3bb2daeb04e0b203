#include "closed_form/disc_between_plates.hpp"

#include <algorithm>
#include <cmath>

#include "signorini/core/bisection.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {

Eigen::Vector3d loaded_diameter_stress(const LineContact& plate, double disc, double depth) {
  require_argument(depth >= 0 && depth <= disc, "disc of radius ", disc, ": no depth of ", depth);
  const double uniform = brazilian_strength({disc, plate.force});
  const double opposite = 2 * plate.force / (pi * (2 * disc - depth));
  return hertz_stress(plate, 0, depth) + Eigen::Vector3d(uniform, uniform - opposite, 0);
}

double tension_depth(const LineContact& plate, double disc) {
  const auto across = [&](double depth) { return loaded_diameter_stress(plate, disc, depth)[0]; };
  require_argument(across(disc) > 0, "disc of radius ", disc,
                   ": compressed up to the centre, the contact is too wide for the theory");
  return bisected(0, disc, [&](double depth) { return across(depth) < 0; }).second;
}

Eigen::Vector3d plate_loaded_disc_stress(const LineContact& plate, double disc, double x,
                                         double y) {
  const double b = hertz_half_width(plate);
  require_argument(b < disc, "disc of radius ", disc, ": the contact is as wide as the disc");
  // Distance from the loaded arcs, by the nearest of some of their points.
  double distance = 2 * disc;
  for (int k = -16; k <= 16; ++k) {
    const double at = b * k / 16;
    const double height = std::sqrt((disc - at) * (disc + at));
    distance = std::min(distance, std::hypot(x - at, std::abs(y) - height));
  }
  require_argument(distance >= 0.01 * b, "disc of radius ", disc, ": the point (", x, ", ", y,
                   ") lies too near to the contact for the sum");
  const int n = 16 + static_cast<int>(20 * b / distance);
  Eigen::Vector3d stress = Eigen::Vector3d::Zero();
  for (int k = 1; k <= n; ++k) {
    const double angle = k * pi / (n + 1);
    // 2/pi of the weights, whose sum is pi/2: shares of P
    const double share = 2.0 / (n + 1) * std::sin(angle) * std::sin(angle);
    stress += line_loaded_disc_stress({disc, share * plate.force}, x, y, b * std::cos(angle));
  }
  return stress;
}

}  // namespace signorini

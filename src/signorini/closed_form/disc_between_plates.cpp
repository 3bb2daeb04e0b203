#include "signorini/closed_form/disc_between_plates.hpp"

#include <algorithm>
#include <cmath>

#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

const double pi = std::acos(-1.0);

}  // namespace

Eigen::Vector3d loaded_diameter_stress(const LineContact& plate, double disc, double depth) {
  require(depth >= 0 && depth <= disc, "disc of radius ", disc, ": no depth of ", depth);
  const double uniform = brazilian_strength({disc, plate.force});
  const double opposite = 2 * plate.force / (pi * (2 * disc - depth));
  return hertz_stress(plate, 0, depth) + Eigen::Vector3d(uniform, uniform - opposite, 0);
}

double tension_depth(const LineContact& plate, double disc) {
  double low = 0;
  double high = disc;
  require(loaded_diameter_stress(plate, disc, high)[0] > 0, "disc of radius ", disc,
          ": compressed up to the centre, the contact is too wide for the theory");
  while (true) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) return high;
    (loaded_diameter_stress(plate, disc, middle)[0] < 0 ? low : high) = middle;
  }
}

Eigen::Vector3d chord_loaded_disc_stress(const SqueezedDisc& disc, double offset, double x,
                                         double y) {
  const double R = disc.radius;
  require(std::abs(offset) < R && std::hypot(x, y) <= R * (1 + 1e-12), "disc of radius ", R,
          ": a chord at ", offset, " or the point (", x, ", ", y, ") lies outside");
  const double half = std::sqrt((R - offset) * (R + offset));
  const double uniform = brazilian_strength(disc) * half / R;
  Eigen::Vector3d stress(uniform, uniform, 0);
  for (const double side : {1.0, -1.0}) {
    const double across = x - offset;
    const double depth = half - side * y;
    const double r2 = across * across + depth * depth;
    require(r2 > 0, "disc of radius ", R, ": the point (", x, ", ", y, ") lies under a load");
    const double radial = -2 * disc.force / pi * depth / (r2 * r2);
    stress += radial * Eigen::Vector3d(across * across, depth * depth, -side * across * depth);
  }
  return stress;
}

Eigen::Vector3d plate_loaded_disc_stress(const LineContact& plate, double disc, double x,
                                         double y) {
  const double b = hertz_half_width(plate);
  require(b < disc, "disc of radius ", disc, ": the contact is as wide as the disc");
  // Distance from the loaded arcs, by the nearest of some of their points.
  double distance = 2 * disc;
  for (int k = -16; k <= 16; ++k) {
    const double at = b * k / 16;
    const double height = std::sqrt((disc - at) * (disc + at));
    distance = std::min(distance, std::hypot(x - at, std::abs(y) - height));
  }
  require(distance >= 0.01 * b, "disc of radius ", disc, ": the point (", x, ", ", y,
          ") lies too near to the contact for the sum");
  const int n = 16 + static_cast<int>(20 * b / distance);
  Eigen::Vector3d stress = Eigen::Vector3d::Zero();
  for (int k = 1; k <= n; ++k) {
    const double angle = k * pi / (n + 1);
    // 2/pi of the weights, whose sum is pi/2: shares of P
    const double share = 2.0 / (n + 1) * std::sin(angle) * std::sin(angle);
    stress += chord_loaded_disc_stress({disc, share * plate.force}, b * std::cos(angle), x, y);
  }
  return stress;
}

}  // namespace signorini

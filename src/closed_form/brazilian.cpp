#include "closed_form/brazilian.hpp"

#include <cmath>
#include <complex>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

void check(const SqueezedDisc& disc) {
  require_argument(disc.radius > 0 && disc.force > 0,
                   "disc: radius and force must be positive, got ", disc.radius, " and ",
                   disc.force);
}

}  // namespace

double brazilian_strength(const SqueezedDisc& disc) {
  check(disc);
  const double d = 2 * disc.radius;
  return 2 * disc.force / (pi * d);
}

Eigen::Vector3d line_loaded_disc_stress(const SqueezedDisc& disc, double x, double y,
                                        double offset) {
  const double strength = brazilian_strength(disc);
  const double R = disc.radius;
  require_argument(std::abs(offset) < R && std::hypot(x, y) <= R * (1 + 1e-12), "disc of radius ",
                   R, ": loads at x = ", offset, " or the point (", x, ", ", y, ") lie outside");
  const double half = std::sqrt((R - offset) * (R + offset));
  const double uniform = strength * half / R;
  Eigen::Vector3d stress(uniform, uniform, 0);
  for (const double side : {1.0, -1.0}) {
    const double across = x - offset;
    const double depth = half - side * y;
    const double r2 = across * across + depth * depth;
    require_argument(r2 > 0, "disc of radius ", R, ": the point (", x, ", ", y,
                     ") lies under a load");
    const double radial =
        -2 * disc.force / pi * depth / (r2 * r2);  // all the stress of a line load
    stress += radial * Eigen::Vector3d(across * across, depth * depth, -side * across * depth);
  }
  return stress;
}

Eigen::Vector3d arc_loaded_disc_stress(const SqueezedDisc& disc, double half_angle, double x,
                                       double y) {
  check(disc);
  const double rho2 = (x * x + y * y) / (disc.radius * disc.radius);
  require_argument(half_angle > 0 && half_angle <= pi / 2 && rho2 < 1, "disc of radius ",
                   disc.radius, ": need half an arc in (0, pi/2] and a point inside, got ",
                   half_angle, " and (", x, ", ", y, ")");
  const double theta = std::atan2(x, y);
  const std::complex<double> ahead = std::polar(1.0, 2 * (half_angle + theta));
  const std::complex<double> behind = std::polar(1.0, 2 * (half_angle - theta));
  const std::complex<double> sum_ahead = ahead / (1.0 - rho2 * ahead);
  const std::complex<double> sum_behind = behind / (1.0 - rho2 * behind);
  const double angles = std::arg(1.0 - rho2 * ahead) + std::arg(1.0 - rho2 * behind);
  const double p_pi = disc.force / (2 * disc.radius * std::sin(half_angle)) / pi;
  const double mean = -2 * p_pi * (half_angle - angles / 2);
  const double half = -p_pi * (1 - rho2) * (sum_ahead + sum_behind).imag();  // sr = mean + half
  const double shear = p_pi * (1 - rho2) * (sum_behind - sum_ahead).real();
  // The radial direction is (sin, cos) of theta, the other (cos, -sin).
  const double c2 = std::cos(2 * theta);
  const double s2 = std::sin(2 * theta);
  return {mean - half * c2 + shear * s2, mean + half * c2 - shear * s2, half * s2 + shear * c2};
}

}  // namespace signorini

#include "closed_form/footing.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

void check(const RigidStrip& strip) {
  const double a = strip.half_width;
  require_argument(
      a > 0 && strip.force > 0 && 2 * std::abs(strip.eccentricity) <= a,
      "rigid strip: half-width and force must be positive and the load within half of the "
      "half-width, got ",
      a, ", ", strip.force, ", ", strip.eccentricity);
}

}  // namespace

double rigid_strip_pressure(const RigidStrip& strip, double x) {
  check(strip);
  const double a = strip.half_width;
  if (std::abs(x) > a) return 0;
  return strip.force / (pi * std::sqrt((a - x) * (a + x))) *
         (1 + 2 * strip.eccentricity * x / (a * a));
}

double rigid_strip_force(const RigidStrip& strip, double from, double to) {
  check(strip);
  const auto up_to = [&](double x) {
    const double X = std::clamp(x / strip.half_width, -1.0, 1.0);
    return std::asin(X) - 2 * strip.eccentricity / strip.half_width * std::sqrt(1 - X * X);
  };
  return strip.force / pi * (up_to(to) - up_to(from));
}

double rigid_strip_rotation(const RigidStrip& strip, double modulus) {
  check(strip);
  require_argument(modulus > 0, "rigid strip: modulus must be positive, got ", modulus);
  return 4 * strip.force * strip.eccentricity /
         (pi * modulus * strip.half_width * strip.half_width);
}

Eigen::Vector3d rigid_strip_stress(const RigidStrip& strip, double x, double depth) {
  check(strip);
  const double a = strip.half_width;
  require_argument(
      depth >= 0 && (depth > 0 || std::abs(x) != a),
      "rigid strip: need a depth that is not negative, on the surface away from the edges, got ",
      depth, " at x = ", x);
  // The roots one by one: their product has no jump in the half-plane. On the surface the sign of
  // the zero keeps us on its side.
  const std::complex<double> w(x, -depth);
  const std::complex<double> left(a + x, -depth);
  const std::complex<double> right(a - x, depth);
  const std::complex<double> root = std::sqrt(left) * std::sqrt(right);
  const double tilt = 2 * strip.eccentricity / (a * a);
  const std::complex<double> Z = -strip.force / pi * (1.0 + tilt * w) / root;
  const std::complex<double> slope =
      -strip.force / pi * (tilt + (1.0 + tilt * w) * w / (left * right)) / root;
  return {Z.real() + depth * slope.imag(), Z.real() - depth * slope.imag(), depth * slope.real()};
}

}  // namespace signorini

#include <algorithm>
#include <cmath>

#include "exercise.hpp"
#include "signorini/core/errors.hpp"

namespace ex12_1 {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const double pi = std::acos(-1.0);

// The ray's pressure as a tensor; no care for the edge of a half-plane.
Vector3d along_ray(double force, const Vector2d& ray, const Vector2d& direction) {
  const double r2 = ray.squaredNorm();
  const double scale = -2 * force / pi * ray.dot(direction) / (r2 * r2);
  return scale * Vector3d(ray.x() * ray.x(), ray.y() * ray.y(), ray.x() * ray.y());
}

}  // namespace

Vector3d line_load_stress(double force, const Vector2d& foot, const Vector2d& direction,
                          const Vector2d& at) {
  const Vector2d ray = at - foot;
  signorini::require_argument(ray.norm() > 0,
                              "line_load_stress: the stress under a force has no limit");
  signorini::require_argument(ray.dot(direction) >= 0,
                              "line_load_stress: point above the half-plane");
  return along_ray(force, ray, direction);
}

Vector3d disc_stress(double radius, double force, double angle, const Vector2d& at) {
  signorini::require_argument(radius > 0 && force > 0,
                              "disc_stress: radius and force must be positive");
  signorini::require_argument(at.norm() <= radius * (1 + 1e-12),
                              "disc_stress: point outside of the disc");
  const Vector2d outward(std::sin(angle), std::cos(angle));
  const Vector2d first = at - radius * outward, second = at + radius * outward;
  signorini::require_argument(std::min(first.norm(), second.norm()) > 1e-12 * radius,
                              "disc_stress: point under a load");
  const double tension = force / (pi * radius);
  return along_ray(force, first, -outward) + along_ray(force, second, outward) +
         Vector3d(tension, tension, 0);
}

}  // namespace ex12_1

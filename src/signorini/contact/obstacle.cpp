// # Rigid obstacles
//
// An obstacle is the simplest target, a function from a point to a gap and a normal. The gap is
// linearised at the point's place in the mesh: \f$gap(u) = g + n\cdot u\f$. So a curved obstacle
// is replaced by its tangent there, which is right as long as the point slides little beside the
// radius.
//
// A disc of radius 5 whose top is the origin, seen from the height 0.1: right above it the gap is
// 0.1. At \f$x = 1\f$ it is 0.1971, where the parabola \f$0.1 + x^2/(2R)\f$ of Hertz's theory says
// 0.2.

#include "signorini/contact/obstacle.hpp"

#include <cmath>

#include "signorini/core/errors.hpp"
#include "signorini/core/exact_sum.hpp"

namespace signorini {
namespace {

/// Distance from a centre and the direction away from it.
///
/// In the centre all directions are the same distance away, and no normal is better than another.
ObstacleContact seen_from(const Eigen::Vector2d& x, const Eigen::Vector2d& centre,
                          const std::string& name) {
  const Eigen::Vector2d arm = x - centre;
  const double distance = arm.norm();
  require_input(distance > 0, "obstacle '", name, "': the point (", x.x(), ", ", x.y(),
                ") lies in its centre, where no normal exists");
  return {distance, arm / distance};
}

/// A circle that the body lies outside of (side 1) or inside of (side -1).
///
/// One function for both sides of a circle: a hole is a disc whose gap and normal have the other
/// sign. A gap is what two large numbers leave. Beside a radius of 60 the rounding of a distance is
/// 1e-14, and where bodies hardly move that is more than their gaps may be wrong by. So the gap is
/// \f$ (|a|^2 - R^2) / (|a| + R) \f$ with the arm a from the centre, and its numerator is summed exactly.
Obstacle circle(const char* name, const Eigen::Vector2d& centre, double radius, double side) {
  require_input(radius > 0 && std::isfinite(radius) && centre.allFinite(), "obstacle '", name,
                "': the radius must be positive, got ", radius);
  return {name, [name, centre, radius, side](const Eigen::Vector2d& x) {
            const ObstacleContact seen = seen_from(x, centre, name);
            ExactSum beyond;
            for (const int axis : {0, 1}) {
              ExactSum arm(x(axis));
              arm.add(-centre(axis));
              beyond.add_product(arm.high(), arm.high());
              beyond.add_product(2 * arm.high(), arm.low());
            }
            beyond.add_product(-radius, radius);
            return ObstacleContact{side * beyond.value() / (seen.gap + radius), side * seen.normal};
          }};
}

}  // namespace

/// The only obstacle whose true gap is linear. A normal of any length is taken; very long and very
/// short ones must not overflow when they are squared. Along a slope the two products cancel, and
/// what is left is summed exactly, as beside a circle.
Obstacle half_plane(const Eigen::Vector2d& point, const Eigen::Vector2d& normal) {
  require_input(
      point.allFinite() && normal.allFinite() && normal.stableNorm() > 0,
      "obstacle 'half plane': needs a finite point and a normal of positive length, got (",
      normal.x(), ", ", normal.y(), ')');
  const Eigen::Vector2d n = normal.stableNormalized();
  return {"half plane",
          [point, n](const Eigen::Vector2d& x) {
            ExactSum gap;
            for (const int axis : {0, 1}) {
              gap.add_product(n(axis), x(axis));
              gap.add_product(-n(axis), point(axis));
            }
            return ObstacleContact{gap.value(), n};
          },
          true};
}

Obstacle disc(const Eigen::Vector2d& centre, double radius) {
  return circle("disc", centre, radius, 1);
}

Obstacle hole(const Eigen::Vector2d& centre, double radius) {
  return circle("hole", centre, radius, -1);
}

/// Classical theory of a pin in its hole is linear in the clearance, and this function is that
/// theory. For a hole of radius 5, a pin of radius 4.8 that touches at the pole, and a point 1 rad
/// away, the gap is 0.0919 here, and 0.0948 to the exact circle.
Obstacle pin_in_hole(const Eigen::Vector2d& hole_centre, double clearance,
                     const Eigen::Vector2d& shift) {
  require_input(hole_centre.allFinite() && shift.allFinite() && std::isfinite(clearance),
                "obstacle 'pin': centre, clearance and shift must be finite, got the clearance ",
                clearance);
  return {"pin",
          [hole_centre, clearance, shift](const Eigen::Vector2d& x) {
            const Eigen::Vector2d n = seen_from(x, hole_centre, "pin").normal;
            return ObstacleContact{clearance - n.dot(shift), n};
          },
          true, true};
}

/// The distance at the same \f$x\f$, times the cosine of the slope. It is not the shortest
/// distance, but differs from it only by gap squared times curvature. For the disc above, as the
/// parabola \f$-x^2/10\f$, it is 0.1961 at \f$x = 1\f$.
Obstacle profile(const std::function<double(double)>& height,
                 const std::function<double(double)>& slope) {
  require_argument(height && slope, "profile: needs a height and a slope");
  return {"profile", [height, slope](const Eigen::Vector2d& x) {
            const double f = height(x.x());
            const double df = slope(x.x());
            require_input(std::isfinite(f) && std::isfinite(df), "obstacle 'profile': height ", f,
                          " and slope ", df, " at x = ", x.x(), " must be finite");
            const double root = std::hypot(df, 1.0);
            const Eigen::Vector2d normal(-df / root, 1 / root);
            return ObstacleContact{normal.y() * (x.y() - f), normal};
          }};
}

}  // namespace signorini

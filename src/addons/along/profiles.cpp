#include "addons/along/profiles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/exact_sum.hpp"
#include "signorini/core/plane.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d, Eigen::VectorXd;

void check_points(const NodeArray& points, const std::string& name) {
  require_input(points.rows() >= 2, "obstacle '", name, "': needs two points or more, got ",
                points.rows());
  require_input(points.allFinite(), "obstacle '", name, "': every coordinate must be finite");
  for (Index k = 1; k < points.rows(); ++k)
    require_input(points.row(k) != points.row(k - 1), "obstacle '", name, "': the points ", k,
                  " and ", k + 1, " are the same, (", points(k, 0), ", ", points(k, 1),
                  "): leave one of them out");
}

Vector2d left_of(const Vector2d& way) { return Vector2d(-way.y(), way.x()); }

/// The normal at a corner, towards a point: between those of the lines that meet there, whatever rounding says of a point that is
/// hardly away from the corner. \param way  from the corner to the point, or the opposite one behind the profile
Vector2d at_corner(const Vector2d& way, const Vector2d& before, const Vector2d& behind) {
  const double turn = cross(before, behind);
  if (way.isZero(0)) return (before + behind).stableNormalized();
  const Vector2d direction = way.stableNormalized();
  if (cross(before, direction) * turn > 0 && cross(direction, behind) * turn > 0) return direction;
  return before.dot(direction) > behind.dot(direction) ? before : behind;
}

/// Straight lines from point to point.
class Chords {
 public:
  explicit Chords(NodeArray points)
      : points_(std::move(points)), closed_(points_.row(0) == points_.bottomRows(1)) {
    for (Index k = 0; k < count(); ++k) {
      const Vector2d way = points_.row(k + 1) - points_.row(k);
      length_.push_back(way.norm());
      normal_.push_back(left_of(way).stableNormalized());
      const bool back = k > 0 && (normal(k) + normal(k - 1)).norm() <= 4 * epsilon;
      require_input(!back, "obstacle: behind point ", k + 1, ", (", from(k).x(), ", ", from(k).y(),
                    "), the profile goes back the way it came, and neither side of it is free");
    }
  }

  [[nodiscard]] Index count() const { return points_.rows() - 1; }

  /// The closest place: number of the chord, and how far along it, 0 to its length, beyond at open ends.
  struct Closest {
    Index chord;
    double along;
    double apart;
  };
  [[nodiscard]] Closest closest(const Vector2d& x) const {
    Closest found{0, 0, std::numeric_limits<double>::infinity()};
    for (Index k = 0; k < count(); ++k) {
      const Vector2d arm = x - from(k);
      double along = arm.dot(tangent(k));
      if (closed_ || k > 0) along = std::max(along, 0.0);
      if (closed_ || k + 1 < count()) along = std::min(along, length(k));
      const double apart = (arm - along * tangent(k)).norm();
      if (apart < found.apart) found = {k, along, apart};
    }
    return found;
  }

  [[nodiscard]] Vector2d from(Index chord) const { return points_.row(chord); }
  [[nodiscard]] const Vector2d& normal(Index chord) const { return normal_[index(chord)]; }
  [[nodiscard]] Vector2d tangent(Index chord) const { return -left_of(normal(chord)); }
  [[nodiscard]] double length(Index chord) const { return length_[index(chord)]; }

  /// \param x  a point whose closest place is known
  [[nodiscard]] ObstacleContact look(const Vector2d& x) const {
    const Closest place = closest(x);
    Index before = place.chord;
    Index behind = place.chord;
    if (place.along <= 0 && (closed_ || before > 0)) before = (before + count() - 1) % count();
    if (place.along >= length(place.chord) && (closed_ || behind + 1 < count()))
      behind = (behind + 1) % count();
    if (before == behind) return {above(before, x), normal(before)};
    // At a corner: which side of it the point is on says the mean of both normals.
    const Vector2d way = x - from(behind);
    const double side = way.dot(normal(before) + normal(behind)) < 0 ? -1 : 1;
    const Vector2d there = at_corner(side * way, normal(before), normal(behind));
    return {way.dot(there), there};
  }

 private:
  static std::size_t index(Index chord) { return static_cast<std::size_t>(chord); }

  /// How far above a chord, or its line, a point is: twice the area of the triangle of the three by the length. Its six products are
  /// summed exactly, as they leave a gap of the places where bodies hardly move.
  [[nodiscard]] double above(Index chord, const Vector2d& x) const {
    const Vector2d corners[] = {points_.row(chord), points_.row(chord + 1), x};
    ExactSum area;
    for (int k = 0; k < 3; ++k) {
      const Vector2d &a = corners[k], &b = corners[(k + 1) % 3];
      area.add_product(a.x(), b.y());
      area.add_product(-a.y(), b.x());
    }
    return area.value() / length(chord);
  }

  NodeArray points_;
  bool closed_;
  std::vector<double> length_;
  std::vector<Vector2d> normal_;
};

/// The natural cubic spline through points, over the length of the chords.
class Spline {
 public:
  explicit Spline(const NodeArray& points) : points_(points), at_(points.rows()) {
    at_(0) = 0;
    for (Index k = 1; k < at_.size(); ++k)
      at_(k) = at_(k - 1) + (points.row(k) - points.row(k - 1)).norm();
    bend_ = second_derivatives();
  }

  [[nodiscard]] Index pieces() const { return at_.size() - 1; }
  [[nodiscard]] double begin(Index piece) const { return at_(piece); }
  [[nodiscard]] double end() const { return at_(pieces()); }

  /// Place, tangent and curvature vector at a parameter; straight beyond the ends.
  struct Frame {
    Vector2d x, slope, bend;
  };
  [[nodiscard]] Frame frame(double t) const {
    const double within = std::min(std::max(t, 0.0), end());
    const auto above = std::upper_bound(at_.begin() + 1, at_.end() - 1, within);
    const Index k = above - at_.begin() - 1;
    const double h = at_(k + 1) - at_(k);
    const double a = (at_(k + 1) - within) / h;
    const double b = (within - at_(k)) / h;
    const Vector2d p = points_.row(k), q = points_.row(k + 1), u = bend_.row(k),
                   v = bend_.row(k + 1);
    Frame found;
    found.x = a * p + b * q + ((a * a * a - a) * u + (b * b * b - b) * v) * (h * h / 6);
    found.slope = (q - p) / h + ((1 - 3 * a * a) * u + (3 * b * b - 1) * v) * (h / 6);
    found.bend = a * u + b * v;
    if (t != within) found.x += (t - within) * found.slope;
    return found;
  }

 private:
  /// The tridiagonal system of the natural spline, solved from the first row to the last and back.
  [[nodiscard]] NodeArray second_derivatives() const {
    const Index n = at_.size();
    NodeArray right = NodeArray::Zero(n, 2);
    VectorXd upper = VectorXd::Zero(n);
    for (Index k = 1; k + 1 < n; ++k) {
      const double before = at_(k) - at_(k - 1);
      const double behind = at_(k + 1) - at_(k);
      const double pivot = 2 * (before + behind) - before * upper(k - 1);
      upper(k) = behind / pivot;
      right.row(k) = (6 * ((points_.row(k + 1) - points_.row(k)) / behind -
                           (points_.row(k) - points_.row(k - 1)) / before) -
                      before * right.row(k - 1)) /
                     pivot;
    }
    for (Index k = n - 2; k > 0; --k) right.row(k) -= upper(k) * right.row(k + 1);
    return right;
  }

  NodeArray points_;
  VectorXd at_;
  NodeArray bend_;
};

/// Where the way from the curve to a point stands square on it, from a place near that: Newton's method between bounds.
double square_on(const Spline& curve, const Vector2d& x, double t, double low, double high) {
  for (int k = 0; k < 60; ++k) {
    const Spline::Frame at = curve.frame(t);
    const double slope = (at.x - x).dot(at.slope);  // of half the square of the distance
    (slope < 0 ? low : high) = t;
    const double bend = at.slope.squaredNorm() + (at.x - x).dot(at.bend);
    double next = bend > 0 ? t - slope / bend : low - 1;
    if (!(next > low && next < high)) next = (low + high) / 2;
    if (std::abs(next - t) <= 1e-15 * (1 + std::abs(t))) return next;
    t = next;
  }
  return t;
}

}  // namespace

Obstacle polyline(const NodeArray& points) {
  check_points(points, "polyline");
  const auto chords = std::make_shared<const Chords>(points);
  return {"polyline", [chords](const Vector2d& x) { return chords->look(x); }};
}

Obstacle spline(const NodeArray& points) {
  check_points(points, "spline");
  require_input(
      points.row(0) != points.bottomRows(1),
      "obstacle 'spline': the first point is the last, but it is no closed curve: leave out the "
      "last point, or take a polyline");
  constexpr Index chords_of_piece = 8;
  const auto curve = std::make_shared<const Spline>(points);
  NodeArray fine(curve->pieces() * chords_of_piece + 1, 2);
  VectorXd place(fine.rows());
  for (Index k = 0; k < fine.rows(); ++k) {
    const Index piece = std::min(k / chords_of_piece, curve->pieces() - 1);
    const double next = piece + 1 < curve->pieces() ? curve->begin(piece + 1) : curve->end();
    const double share = static_cast<double>(k - piece * chords_of_piece) / chords_of_piece;
    place(k) = curve->begin(piece) + share * (next - curve->begin(piece));
    fine.row(k) = curve->frame(place(k)).x.transpose();
  }
  const auto chords = std::make_shared<const Chords>(fine);
  return {"spline", [curve, chords, place](const Vector2d& x) {
            const Chords::Closest near = chords->closest(x);
            const double share = near.along / chords->length(near.chord);
            const double from = place(near.chord);
            const double width = place(near.chord + 1) - from;
            // A chord more on either side; at the ends as far as the straight line goes.
            const double low =
                near.chord == 0 ? from + std::min(share - 1, -1.0) * width : place(near.chord - 1);
            const double high = near.chord + 1 == chords->count()
                                    ? from + std::max(share + 1, 2.0) * width
                                    : place(near.chord + 2);
            const double t = square_on(*curve, x, from + share * width, low, high);
            const Spline::Frame at = curve->frame(t);
            const Vector2d normal = left_of(at.slope).stableNormalized();
            return ObstacleContact{normal.dot(x - at.x), normal};
          }};
}

}  // namespace signorini

// # A side as a curve
//
// Contact needs three things of a side: a point, a normal, and the place that is nearest to a
// point of another body. A side is a straight line or a parabola,
//
// \f[ x(\xi) = x_m + \xi\,s + \xi^2\,b, \qquad s = \tfrac12(x_2 - x_1), \quad b = \tfrac12(x_1 + x_2) - x_m, \f]
//
// with the middle node \f$x_m\f$ and \f$b = 0\f$ on a straight side. At the closest place the way
// to the point \f$p\f$ is normal to the curve: \f$f(\xi) = (x(\xi) - p)\cdot x'(\xi) = 0\f$. That
// is linear on a line, and of third degree on a parabola. A parabola can have two places that are
// nearest, and one between them that is farthest. For \f$x = (\xi,\ \xi^2 - 1)\f$ and
// \f$p = (0, 0)\f$ they are \f$\xi = \pm 0.707\f$ and 0. Newton's method from \f$\xi = 0\f$ would
// stay there, at the worst place. So the extreme points of \f$f\f$, which a quadratic equation
// gives, cut \f$[-1, 1]\f$ into pieces on which \f$f\f$ rises or falls, and each root is looked
// for on its own piece.
//
// The body lies to the left of the walk, hence \f$n = (t_y, -t_x)\f$ points out of it. An
// AnchoredPoint keeps a node and the way from it apart, so that differences of places are exact to
// rounding of the way. A gap is a difference that may be smaller than that. A way of 0.25 is rounded
// by 3e-17. A block of steel under its own weight moves by 1e-9, and there a gap of 3e-17 changes the
// eighth digit of its forces. So what rounding takes from the way is kept as well.

#include "signorini/fem/side_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "signorini/core/errors.hpp"
#include "signorini/core/exact_sum.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Array2d, Eigen::Index, Eigen::Vector2d;
using Sums = ExactSumOf<Array2d>;  // of x and y

/// (x(xi) - x) . x'(xi) as a polynomial of third degree: negative where the distance falls.
struct Cubic {
  double c[4];
  double operator()(double s) const { return c[0] + s * (c[1] + s * (c[2] + s * c[3])); }
  [[nodiscard]] double slope(double s) const { return c[1] + s * (2 * c[2] + s * 3 * c[3]); }
};

/// Roots of a + 2 b s + c s^2 between two bounds, increasing; without cancellation.
///
/// The usual formula subtracts two numbers that are nearly equal if \f$b^2 \gg ac\f$. Here the two
/// terms have the same sign in \f$q\f$, and the second root is a quotient.
std::vector<double> roots(double a, double b, double c, double low, double high) {
  std::vector<double> found;
  const auto keep = [&](double s) {
    if (s > low && s < high) found.push_back(s);  // never true for a quotient that is not finite
  };
  const double discriminant = b * b - a * c;
  if (discriminant < 0) return found;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  if (q != 0) keep(a / q);
  if (c != 0 && (discriminant > 0 || q == 0)) keep(q / c);
  std::sort(found.begin(), found.end());
  return found;
}

/// The root between two places where f <= 0 and f >= 0 and in between f rises: Newton's method,
/// halving where it leaves the bounds.
///
/// Newton's method alone may leave the interval, and halving alone is slow. Each step keeps a
/// bracket \f$[low, high]\f$ around the root.
double rising_root(const Cubic& f, double low, double high) {
  double s = low + (high - low) * (f(low) / (f(low) - f(high)));
  for (int step = 0; step < 60; ++step) {
    if (!(s >= low && s <= high)) s = low + (high - low) / 2;
    const double value = f(s);
    (value <= 0 ? low : high) = s;
    const double next = s - value / f.slope(s);
    if (!(std::abs(next - s) > epsilon)) break;
    s = next;
  }
  return std::clamp(s, low, high);
}

}  // namespace

/// The arm grows by a product of which nothing is lost. What the way itself lacks is so small that
/// its product may be rounded.
AnchoredPoint AnchoredPoint::moved(double share, const ExactWay& way) const {
  Sums arm(arm_, rest_);
  arm.add_product(Array2d::Constant(share), way.rounded);
  arm.add(share * way.rest.array());
  return {anchor_, arm.high(), arm.low()};
}

/// Anchors first: of two nodes that lie far from the origin and near each other all leading digits
/// cancel. The arms then cancel most of what is left, and the rests say the last digits of a gap.
ExactWay AnchoredPoint::way_from(const AnchoredPoint& from) const {
  Sums way(anchor_, rest_ - from.rest_);
  for (const Vector2d& part : {Vector2d(-from.anchor_), arm_, Vector2d(-from.arm_)}) way.add(part);
  return {way.value(), (way.high() - way.value()) + way.low()};
}

SideShape side_shape(std::size_t n_nodes, double xi) {
  if (n_nodes == 2) return {{(1 - xi) / 2, (1 + xi) / 2, 0}, {-0.5, 0.5, 0}};
  return {{xi * (xi - 1) / 2, 1 - xi * xi, xi * (xi + 1) / 2}, {xi - 0.5, -2 * xi, xi + 0.5}};
}

/// A side of two nodes is a parabola that does not bend, so that one set of formulas serves both.
/// Half of a number is exact.
SideCurve::SideCurve(const Mesh& mesh, const CellSide& side)
    : nodes_(mesh.side_nodes(side)),
      first_(mesh.nodes.row(nodes_.front())),
      last_(mesh.nodes.row(nodes_.back())),
      middle_(first_) {
  const ExactWay chord = AnchoredPoint(last_).way_from(first_);
  slope_ = {chord.rounded / 2, chord.rest / 2};
  middle_ = middle_.moved(1, slope_);
  if (nodes_.size() == 2) return;
  const AnchoredPoint of_chord = middle_;
  middle_ = mesh.nodes.row(nodes_[1]).transpose();
  bend_ = of_chord.way_from(middle_);
}

/// Ends are the nodes to the last bit: two sides that meet agree on where. In between
/// \f$ w = s + \xi b \f$ is computed first, and the place is the middle moved by \f$ \xi w \f$. On a
/// straight line b is nothing, and one product is enough.
AnchoredPoint SideCurve::point(double xi) const {
  if (xi == -1) return first_;
  if (xi == 1) return last_;
  if (nodes_.size() == 2) return middle_.moved(xi, slope_);
  const AnchoredPoint origin(0, 0);
  return middle_.moved(xi, origin.moved(1, slope_).moved(xi, bend_).way_from(origin));
}

/// The body is on the left of the walk, so that outwards is a quarter turn to the right.
Vector2d SideCurve::normal(double xi) const {
  const Vector2d t = tangent(xi).normalized();
  return {t.y(), -t.x()};
}

/// The tangents at the two ends of a parabola meet at \f$x_m - b\f$. A box around this point and
/// the ends is a little too large, and needs no search for extreme points.
Eigen::Matrix2d SideCurve::box() const {
  // A parabola lies in the triangle of its ends and the point where the tangents there meet.
  const Vector2d apex = middle_.moved(-1, bend_).position();
  Eigen::Matrix2d box;
  box.col(0) = first_.cwiseMin(last_).cwiseMin(apex);
  box.col(1) = first_.cwiseMax(last_).cwiseMax(apex);
  return box;
}

/// The distance falls where \f$f < 0\f$ and rises where \f$f > 0\f$. So a minimum is a root at
/// which \f$f\f$ rises, or the first end if \f$f \ge 0\f$ there, or the last one if \f$f \le 0\f$
/// there. All of them are compared. Equal distances leave the lower \f$\xi\f$, which keeps the
/// answer the same on every machine.
double SideCurve::closest(const AnchoredPoint& x) const {
  const Vector2d arm = middle_ - x;
  const Vector2d &slope = slope_.rounded, &bend = bend_.rounded;
  const Cubic f{{arm.dot(slope), slope.squaredNorm() + 2 * arm.dot(bend), 3 * slope.dot(bend),
                 2 * bend.squaredNorm()}};
  if (nodes_.size() == 2) return std::clamp(-f.c[0] / f.c[1], -1.0, 1.0);
  std::vector<double> bounds = roots(f.c[1], f.c[2], 3 * f.c[3], -1, 1);
  bounds.insert(bounds.begin(), -1);
  bounds.push_back(1);
  double best = -1;
  double nearest = std::numeric_limits<double>::infinity();
  const auto compare = [&](double s) {
    const double distance = (point(s) - x).squaredNorm();
    if (distance < nearest) {
      best = s;
      nearest = distance;
    }
  };
  if (f(-1) >= 0) compare(-1);
  for (std::size_t k = 0; k + 1 < bounds.size(); ++k)
    if (f(bounds[k]) < 0 && f(bounds[k + 1]) >= 0)
      compare(rising_root(f, bounds[k], bounds[k + 1]));
  if (f(1) <= 0) compare(1);
  return best;
}

/// Rounding of coordinates may put a point just beyond the end of a boundary. Four steps of
/// Newton's method from the end follow the curve a little further. If the point lies at the centre
/// of curvature or beyond it, the distance has no minimum there, and the answer is no number.
double SideCurve::continued(const AnchoredPoint& x, int end) const {
  double xi = end;
  for (int step = 0; step < 4; ++step) {
    const Vector2d arm = point(xi) - x;
    const Vector2d t = tangent(xi);
    const double curvature = t.squaredNorm() + 2 * arm.dot(bend_.rounded);
    if (!(curvature > 0)) return std::numeric_limits<double>::quiet_NaN();
    xi -= arm.dot(t) / curvature;
  }
  return xi;
}

/// A line meets the curve where its distance across the line is 0: again a quadratic equation.
std::vector<double> SideCurve::crossings(const AnchoredPoint& x, const Vector2d& direction,
                                         double beyond) const {
  const Vector2d across(direction.y(), -direction.x());
  return roots((middle_ - x).dot(across), slope_.rounded.dot(across) / 2,
               bend_.rounded.dot(across), -1 - beyond, 1 + beyond);
}

/// The normal of a node between two sides is the sum of theirs. It says which way the node looks,
/// and no force acts along it: forces act along the normal of the target.
std::map<Index, NodeOnSide> nodes_on_sides(const std::vector<SideCurve>& sides) {
  std::map<Index, NodeOnSide> found;
  for (const SideCurve& side : sides) {
    const double step = 2.0 / static_cast<double>(side.nodes().size() - 1);
    for (std::size_t k = 0; k < side.nodes().size(); ++k) {
      const double xi = -1 + step * static_cast<double>(k);
      const auto [place, is_new] = found.insert({side.nodes()[k], {&side, xi, side.normal(xi)}});
      if (!is_new) place->second.normal += side.normal(xi);
    }
  }
  return found;
}

std::vector<SideCurve> side_curves(const Mesh& mesh, const std::string& boundary) {
  std::vector<SideCurve> sides;
  for (const CellSide& side : signorini::boundary(mesh, boundary)) sides.emplace_back(mesh, side);
  require_input(!sides.empty(), "mesh '", mesh.name, "': the boundary '", boundary,
                "' has no sides; give it some, or leave it out");
  return sides;
}

}  // namespace signorini

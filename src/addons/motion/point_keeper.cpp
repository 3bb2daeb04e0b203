// # Points that are kept
//
// Gap operators write rows and forget what these were made of. How rows change as bodies move depends on that, so whoever lets
// bodies move hands an operator a keeper, which gets each point as it is found.

#include "addons/motion/point_keeper.hpp"

#include <vector>

#include "addons/motion/jumps.hpp"
#include "signorini/contact/obstacle.hpp"
#include "signorini/contact/pairs.hpp"
#include "signorini/pairing/pair_rows.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::Vector2d;

/// A side is forgotten with its interface. What is left of a place are numbers of nodes, counted through all bodies as
/// columns are, and their shape functions.
SidePlace side_place(const SideCurve& side, double xi, Index first_node) {
  SidePlace place;
  place.value = side.shape(xi).value;
  for (std::size_t k = 0; k < side.nodes().size(); ++k)
    place.node[k] = first_node + side.nodes()[k];
  return place;
}

/// A normal at two places that lie a little before and behind a point, along the obstacle. Of a normal that turns once in a
/// length R the difference is right to \f$ h^2/6R^2 \f$, and rounding takes \f$ 10^{-16}\,x/h \f$ of it.
double turning(const Mesh& mesh, const Obstacle& obstacle, const Vector2d& x, const Vector2d& n) {
  if (obstacle.linear) return 0;
  const Vector2d t(n.y(), -n.x());
  const double h =
      1e-5 * (mesh.nodes.colwise().maxCoeff() - mesh.nodes.colwise().minCoeff()).norm();
  return t.dot(obstacle.look(x + h * t).normal - obstacle.look(x - h * t).normal) / (2 * h);
}

/// What pairs of nodes with an obstacle keep. Each is its own point, with all of the force on one node of a
/// side. The target has no nodes, as nothing can move it.
std::vector<KeptPoint> points_of(const Pairs& pairs, const Surface& source,
                                 const Obstacle& obstacle) {
  std::vector<KeptPoint> points(pairs.node.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Index pair = points[k].pair = static_cast<Index>(k);
    points[k].share = points[k].source.value(0) = 1;
    points[k].source.node[0] = source.first_node + pairs.node[k];
    points[k].normal = pairs.normal.row(pair).transpose();
    points[k].gap = pairs.initial_gap(pair);
    points[k].turning =
        turning(source.mesh, obstacle, pairs.position.row(pair).transpose(), points[k].normal);
  }
  return points;
}

}  // namespace

/// Whoever wants to know how rows change needs the points once they are written. Two sides, each with
/// its nodes, and between them normal and gap: nothing else stands in a row.
KeptPoint kept_point(const Interface& interface, const PairPoint& point, double share) {
  return {point.pair,
          share,
          side_place(*point.side, point.xi, interface.source.first_node),
          side_place(interface.search.side(point.place.side), point.place.xi,
                   interface.target.first_node),
          point.place.xi,
          point.place.normal,
          point.place.gap};
}

const PointKeeper& point_keeper() {
  static const PointKeeper keeper = {kept_point, jumps_along, points_of};
  return keeper;
}

}  // namespace signorini

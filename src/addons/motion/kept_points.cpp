// # Points that pairs keep
//
// A row of N is the mean of what its points read, and once it is written nobody can tell what they were. Bodies that
// move need them: of each point the two sides that face each other, with their nodes, and between them normal and gap.
// Nothing else stands in a row.
//
// Points know the number of their pair among the candidates of a contact. Supports drop some of these, and contacts are
// stacked; so the numbers change, and with them those of the points.

#include "addons/motion/kept_points.hpp"

#include <map>
#include <utility>

#include "addons/motion/jumps.hpp"

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

}  // namespace

KeptPoint kept(const Interface& interface, const PairPoint& point, double share) {
  return {point.pair,
          share,
          side_place(*point.side, point.xi, interface.source.first_node),
          side_place(interface.search.side(point.place.side), point.place.xi,
                     interface.target.first_node),
          point.place.xi,
          point.place.normal,
          point.place.gap};
}

/// Of a jump the numbers of pairs are nodes yet, and its share is none of a total.
KeptPoints kept_points(const MortarPoints& found, const Pairs& pairs) {
  KeptPoints all;
  for (const PairPoint& point : found.points)
    all.points.push_back(kept(found.interface, point, point.amount / found.total(point.pair)));
  std::map<Index, Index> pair_of;
  for (std::size_t pair = 0; pair < pairs.node.size(); ++pair)
    pair_of[pairs.node[pair]] = static_cast<Index>(pair);
  all.jumps = jumps_along(found.edges, found.interface);
  for (KeptJump& jump : all.jumps)
    for (KeptPoint* point : {&jump.before, &jump.behind}) {
      point->pair = pair_of.at(point->pair);
      point->share /= found.total(point->pair);
    }
  return all;
}

/// Of the source's nodes none has moved since the pairs were found.
KeptPoints kept_points(const Pairs& pairs, const Surface& source, const Obstacle& obstacle) {
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
  return {std::move(points), {}};
}

/// A point of a pair that is dropped goes with it: its force would be none. Of a jump both points belong
/// to the same pair.
void append_points(const KeptPoints& from, const std::vector<Index>& number, KeptPoints& to) {
  for (KeptPoint point : from.points) {
    point.pair = number[static_cast<std::size_t>(point.pair)];
    if (point.pair >= 0) to.points.push_back(point);
  }
  for (KeptJump jump : from.jumps) {
    jump.before.pair = jump.behind.pair = number[static_cast<std::size_t>(jump.before.pair)];
    if (jump.before.pair >= 0) to.jumps.push_back(jump);
  }
}

}  // namespace signorini

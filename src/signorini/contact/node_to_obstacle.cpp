// # Nodes against a rigid obstacle
//
// Every node of the boundary is asked what it sees of the obstacle, a gap \f$g\f$ and a normal
// \f$n\f$ out of it. With the displacement \f$u\f$ of the node, and the tangent
// \f$t = (n_y, -n_x)\f$,
//
// \f[ gap = g + n\cdot u, \qquad slip = t\cdot u. \f]
//
// So a row of \f$N\f$ has two entries, and on a flat obstacle that is parallel to an axis one.
// Nothing is searched and nothing is integrated, and an obstacle takes any force: it has no
// unknowns. For a node at the height 0.3 above the ground, \f$n = (0, 1)\f$ and \f$g = 0.3\f$; if
// it sinks by 0.5 the gap is \f$-0.2\f$, an overlap.
//
// The weight is what a pressure of one does to the node along its normal. Force over weight is the
// pressure that is printed.

#include "signorini/contact/node_to_obstacle.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/fem/assembly.hpp"

namespace signorini {

using Eigen::Index;
namespace {

/// What a node sees of the obstacle, whose function anyone may have written.
///
/// A normal that is 1.1 long would make forces 9 % too small, and all balances would still hold.
ObstacleContact look_from(const Mesh& mesh, Index node, const Obstacle& obstacle) {
  const ObstacleContact seen = obstacle.look(mesh.nodes.row(node).transpose());
  require_input(std::isfinite(seen.gap) && seen.normal.allFinite(), "obstacle '", obstacle.name,
                "': the gap at node ", node,
                " is not finite, but it must be wherever the body may be");
  require_input(std::abs(seen.normal.norm() - 1) < 1e-8, "obstacle '", obstacle.name,
                "': the normal at node ", node, " must have length 1, got ", seen.normal.norm());
  return seen;
}

/// Rows of which each reads how far one node of the source moves along a direction of its own.
///
/// Opening and slip differ only in the direction along which the displacement is read.
NodalRows rows_along(const NodeArray& directions, const std::vector<Index>& nodes,
                     const Surface& source, Index n_nodes) {
  NodalRows rows(directions.rows(), 2 * n_nodes);
  rows.reserve(Eigen::VectorXi::Constant(directions.rows(), 2));
  for (Index pair = 0; pair < directions.rows(); ++pair)
    for (int axis = 0; axis < 2; ++axis)
      rows.insert(pair, 2 * (source.first_node + nodes[at(pair)]) + axis) = directions(pair, axis);
  rows.makeCompressed();
  return rows;
}

}  // namespace

/// Nodes that have no share of the boundary are left out: on the axis of a body of revolution no
/// pressure could be told from their force.
Pairs node_to_obstacle(const Surface& source, const Obstacle& obstacle, const GapOptions& options) {
  require_input(static_cast<bool>(obstacle.look), "obstacle '", obstacle.name,
                "': cannot be looked at; make it with half_plane, disc, hole or profile");
  const std::vector<Index> idle = nodes_without_share(source.mesh, source.boundary, options.depth);
  const std::vector<Index> nodes = boundary_nodes(source.mesh, source.boundary);
  Pairs pairs;
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < nodes.size(); ++k)
    if (!std::binary_search(idle.begin(), idle.end(), nodes[k])) {
      pairs.node.push_back(nodes[k]);
      kept.push_back(k);
    }
  pairs.position = source.mesh.nodes(pairs.node, Eigen::all);
  const Index n_pairs = pairs.position.rows();
  pairs.initial_gap.resize(n_pairs);
  pairs.normal.resize(n_pairs, 2);
  NodeArray tangent(n_pairs, 2);
  for (Index pair = 0; pair < n_pairs; ++pair) {
    const auto [gap, n] = look_from(source.mesh, pairs.node[at(pair)], obstacle);
    pairs.initial_gap(pair) = gap;
    pairs.normal.row(pair) << n.x(), n.y();
    tangent.row(pair) << n.y(), -n.x();
  }
  pairs.opening = rows_along(pairs.normal, pairs.node, source, options.n_nodes);
  if (options.sliding) pairs.sliding = rows_along(tangent, pairs.node, source, options.n_nodes);
  // The force acts at the node itself, so it has no moment about it.
  pairs.moment = pairs.target_moment = NodeArray::Zero(n_pairs, 2);
  pairs.weight = weights_of_nodes(
      boundary_areas(source.mesh, source.boundary, options.depth)(kept, Eigen::all), pairs.normal);
  return pairs;
}

}  // namespace signorini

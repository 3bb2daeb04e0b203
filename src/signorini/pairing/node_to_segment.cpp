// # Nodes against sides
//
// The classical operator. A node 3 is projected to the place \f$3'\f$ of a side with the nodes 1
// and 2, at which the shape functions are \f$N_1\f$ and \f$N_2\f$:
//
// \f[ gap = (X_3 - X_{3'})\cdot n + (u_3 - N_1 u_1 - N_2 u_2)\cdot n. \f]
//
// The node (0.25, 0.1) above the side from (1, 0) to (0, 0), whose body lies below:
// \f$n = (0, 1)\f$, the gap is 0.1, \f$N_1 = 0.25\f$ and \f$N_2 = 0.75\f$. The row of \f$N\f$ is 1
// at \f$u_{3y}\f$, -0.25 at \f$u_{1y}\f$ and -0.75 at \f$u_{2y}\f$. Its transpose is the law of
// the lever: of a contact force of 4 the nodes 1 and 2 get 1 and 3.
//
// Only nodes of the source are kept out of the target. A node of the target between two nodes of
// the source may enter it, which is why the finer mesh should be the source.

#include "signorini/pairing/node_to_segment.hpp"

#include <algorithm>
#include <map>

#include "signorini/fem/assembly.hpp"
#include "signorini/pairing/pair_rows.hpp"

namespace signorini {

using Eigen::Index, Eigen::Vector2d;

/// Each node looks along the sum of the normals of its sides, and keeps what it finds. Nodes
/// without a share of the surface, on the axis of a body of revolution, make no pair.
Pairs node_to_segment(const Surface& source, const Surface& target, const GapOptions& options) {
  const Interface interface(source, target, options);
  const std::vector<Index> nodes = boundary_nodes(source.mesh, source.boundary);
  const NodeArray areas = boundary_areas(source.mesh, source.boundary, options.depth);
  const std::map<Index, NodeOnSide> on_side = nodes_on_sides(interface.sides);
  std::vector<PairPoint> points;
  std::vector<std::size_t> paired;
  Pairs pairs;
  const std::vector<Index> idle = nodes_without_share(source.mesh, source.boundary, options.depth);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    if (std::binary_search(idle.begin(), idle.end(), nodes[k])) continue;
    const NodeOnSide& node = on_side.at(nodes[k]);
    const Vector2d x = source.mesh.nodes.row(nodes[k]).transpose();
    const Projection place = interface.closest(x, node.normal);
    (place.found ? pairs.node : pairs.unpaired).push_back(nodes[k]);
    if (!place.found) continue;
    points.push_back({static_cast<Index>(points.size()), node.side, node.xi, place});
    paired.push_back(k);
  }
  interface.check_paired(points.size());
  pairs.position = source.mesh.nodes(pairs.node, Eigen::all);
  write_rows(interface, points, Eigen::VectorXd::Ones(pairs.position.rows()), options, pairs);
  pairs.weight = weights_of_nodes(areas(paired, Eigen::all), pairs.normal);
  return pairs;
}

namespace gap_operator {

GapOperator node_to_segment() {
  return {"node_to_segment", "every node of the source against the side it faces",
          signorini::node_to_segment};
}

}  // namespace gap_operator

}  // namespace signorini

#include "signorini/contact/node_to_segment.hpp"

#include <algorithm>
#include <map>

#include "signorini/contact/pair_rows.hpp"
#include "signorini/fem/assembly.hpp"

namespace signorini {

using Eigen::Index;
using Eigen::Vector2d;

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

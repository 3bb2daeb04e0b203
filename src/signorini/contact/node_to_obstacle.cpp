#include "signorini/contact/node_to_obstacle.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/fem/assembly.hpp"

namespace signorini {

using Eigen::Index;

Pairs node_to_obstacle(const Surface& source, const Obstacle& obstacle, const GapOptions& options) {
  require_input(static_cast<bool>(obstacle.look), "obstacle '", obstacle.name,
                "': cannot be looked at; make it with half_plane, disc, hole or profile");
  Pairs pairs;
  const std::vector<Index> idle = nodes_without_share(source.mesh, source.boundary, options.depth);
  std::vector<Index> kept;
  const std::vector<Index> nodes = boundary_nodes(source.mesh, source.boundary);
  for (std::size_t k = 0; k < nodes.size(); ++k)
    if (!std::binary_search(idle.begin(), idle.end(), nodes[k])) {
      pairs.node.push_back(nodes[k]);
      kept.push_back(static_cast<Index>(k));
    }
  pairs.position = source.mesh.nodes(pairs.node, Eigen::all);
  const Index n_pairs = pairs.position.rows();
  pairs.initial_gap.resize(n_pairs);
  pairs.normal.resize(n_pairs, 2);
  pairs.opening.resize(n_pairs, 2 * options.n_nodes);
  pairs.opening.reserve(Eigen::VectorXi::Constant(n_pairs, 2));
  if (options.sliding) {
    pairs.sliding.resize(n_pairs, 2 * options.n_nodes);
    pairs.sliding.reserve(Eigen::VectorXi::Constant(n_pairs, 2));
  }
  for (Index pair = 0; pair < n_pairs; ++pair) {
    const Index node = pairs.node[static_cast<std::size_t>(pair)];
    const ObstacleContact seen = obstacle.look(pairs.position.row(pair).transpose());
    require_input(std::isfinite(seen.gap) && seen.normal.allFinite(), "obstacle '", obstacle.name,
                  "': the gap at node ", node,
                  " is not finite, but it must be wherever the body may be");
    require_input(std::abs(seen.normal.norm() - 1) < 1e-8, "obstacle '", obstacle.name,
                  "': the normal at node ", node, " must have length 1, got ", seen.normal.norm());
    pairs.initial_gap(pair) = seen.gap;
    pairs.normal.row(pair) = seen.normal.transpose();
    const Index column = 2 * (source.first_node + node);
    pairs.opening.insert(pair, column) = seen.normal.x();
    pairs.opening.insert(pair, column + 1) = seen.normal.y();
    if (!options.sliding) continue;
    pairs.sliding.insert(pair, column) = seen.normal.y();
    pairs.sliding.insert(pair, column + 1) = -seen.normal.x();
  }
  pairs.moment = pairs.target_moment = NodeArray::Zero(n_pairs, 2);
  pairs.weight = weights_of_nodes(
      boundary_areas(source.mesh, source.boundary, options.depth)(kept, Eigen::all), pairs.normal);
  pairs.opening.makeCompressed();
  pairs.sliding.makeCompressed();
  return pairs;
}

}  // namespace signorini

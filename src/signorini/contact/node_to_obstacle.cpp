#include "signorini/contact/node_to_obstacle.hpp"

#include <cmath>

#include "signorini/core/errors.hpp"
#include "signorini/elasticity/assembly.hpp"

namespace signorini {

using Eigen::Index;

Pairs node_to_obstacle(const Surface& source, const Obstacle& obstacle, Index n_nodes,
                       double thickness, bool sliding) {
  pose(static_cast<bool>(obstacle.look), "obstacle '", obstacle.name,
       "': cannot be looked at; make it with half_plane, disc, hole or profile");
  Pairs pairs;
  pairs.node = boundary_nodes(source.mesh, source.boundary);
  pairs.position = source.mesh.nodes(pairs.node, Eigen::all);
  pairs.weight = boundary_weights(source.mesh, source.boundary, thickness);
  const Index n_pairs = pairs.weight.size();
  pairs.initial_gap.resize(n_pairs);
  pairs.normal.resize(n_pairs, 2);
  pairs.opening.resize(n_pairs, 2 * n_nodes);
  pairs.opening.reserve(Eigen::VectorXi::Constant(n_pairs, 2));
  if (sliding) {
    pairs.sliding.resize(n_pairs, 2 * n_nodes);
    pairs.sliding.reserve(Eigen::VectorXi::Constant(n_pairs, 2));
  }
  for (Index pair = 0; pair < n_pairs; ++pair) {
    const Index node = pairs.node[static_cast<std::size_t>(pair)];
    const ObstacleContact seen = obstacle.look(pairs.position.row(pair).transpose());
    pose(std::isfinite(seen.gap) && seen.normal.allFinite(), "obstacle '", obstacle.name,
         "': the gap at node ", node, " is not finite");
    pose(std::abs(seen.normal.norm() - 1) < 1e-8, "obstacle '", obstacle.name,
         "': the normal at node ", node, " must have length 1, got ", seen.normal.norm());
    pairs.initial_gap(pair) = seen.gap;
    pairs.normal.row(pair) = seen.normal.transpose();
    const Index column = 2 * (source.first_node + node);
    pairs.opening.insert(pair, column) = seen.normal.x();
    pairs.opening.insert(pair, column + 1) = seen.normal.y();
    if (!sliding) continue;
    pairs.sliding.insert(pair, column) = seen.normal.y();
    pairs.sliding.insert(pair, column + 1) = -seen.normal.x();
  }
  pairs.opening.makeCompressed();
  pairs.sliding.makeCompressed();
  return pairs;
}

Gaps node_to_obstacle(const Mesh& mesh, const std::string& boundary, const Obstacle& obstacle,
                      const Unknowns& unknowns, double thickness) {
  const Surface source{mesh, boundary};
  return reduce(node_to_obstacle(source, obstacle, mesh.n_nodes(), thickness), source, unknowns,
                text("contact of '", boundary, "' with a rigid ", obstacle.name));
}

}  // namespace signorini

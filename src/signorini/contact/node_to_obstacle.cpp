#include "signorini/contact/node_to_obstacle.hpp"

#include <cmath>
#include <limits>
#include <set>

#include "signorini/core/errors.hpp"
#include "signorini/elasticity/assembly.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// A component of a unit normal that is more than rounding.
bool counts(double component) {
  return std::abs(component) > 4 * std::numeric_limits<double>::epsilon();
}

/// Whether the supports leave the node no motion along the normal.
bool is_held(const Unknowns& unknowns, Index node, const Eigen::Vector2d& normal) {
  for (int axis = 0; axis < 2; ++axis)
    if (unknowns.number(node, axis) >= 0 && counts(normal(axis))) return false;
  return true;
}

/// A side with both ends held cannot open or close: the boundary was meant for a support or for contact.
void check_not_supported(const Mesh& mesh, const std::string& name, const std::set<Index>& held) {
  for (const CellSide& side : boundary(mesh, name)) {
    const std::vector<Index> nodes = mesh.side_nodes(side);
    pose(held.count(nodes.front()) == 0 || held.count(nodes.back()) == 0, "contact boundary '",
         name, "' is also held by a support: nodes ", nodes.front(), " and ", nodes.back(),
         " cannot move along the obstacle's normal. Take the support or the contact off this "
         "boundary");
  }
}

}  // namespace

Gaps node_to_obstacle(const Mesh& mesh, const std::string& name, const Obstacle& obstacle,
                      const Unknowns& unknowns, double thickness) {
  pose(static_cast<bool>(obstacle.look), "obstacle '", obstacle.name,
       "': cannot be looked at; make it with half_plane, disc, hole or profile");
  const std::vector<Index> nodes = boundary_nodes(mesh, name);
  const Eigen::VectorXd weights = boundary_weights(mesh, name, thickness);
  const double size = mesh.nodes.cwiseAbs().maxCoeff();
  std::set<Index> held;
  std::vector<std::size_t> kept;
  std::vector<ObstacleContact> seen;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    seen.push_back(obstacle.look(mesh.nodes.row(nodes[k]).transpose()));
    const ObstacleContact& contact = seen.back();
    pose(std::isfinite(contact.gap) && contact.normal.allFinite(), "obstacle '", obstacle.name,
         "': the gap at node ", nodes[k], " is not finite");
    pose(std::abs(contact.normal.norm() - 1) < 1e-8, "obstacle '", obstacle.name,
         "': the normal at node ", nodes[k], " must have length 1, got ", contact.normal.norm());
    if (!is_held(unknowns, nodes[k], contact.normal)) {
      kept.push_back(k);
      continue;
    }
    held.insert(nodes[k]);
    const double gap = contact.gap + contact.normal.dot(unknowns.held.row(nodes[k]).transpose());
    pose(gap >= -16 * std::numeric_limits<double>::epsilon() * size, "obstacle '", obstacle.name,
         "': node ", nodes[k], " of '", name,
         "' is held by a support and overlaps the obstacle by ", -gap,
         ". Move the obstacle or release the node");
  }
  check_not_supported(mesh, name, held);

  Gaps gaps;
  const Index n_pairs = static_cast<Index>(kept.size());
  gaps.initial_gap.resize(n_pairs);
  gaps.weight.resize(n_pairs);
  gaps.position.resize(n_pairs, 2);
  gaps.normal.resize(n_pairs, 2);
  std::vector<Eigen::Triplet<double>> entries;
  for (Index pair = 0; pair < n_pairs; ++pair) {
    const std::size_t k = kept[static_cast<std::size_t>(pair)];
    const Index node = nodes[k];
    gaps.initial_gap(pair) = seen[k].gap;
    for (int axis = 0; axis < 2; ++axis) {
      const Index unknown = unknowns.number(node, axis);
      const double component = seen[k].normal(axis);
      if (unknown >= 0 && counts(component))
        entries.emplace_back(static_cast<int>(pair), static_cast<int>(unknown), -component);
      else
        gaps.initial_gap(pair) += component * unknowns.held(node, axis);
    }
    gaps.weight(pair) = weights(static_cast<Index>(k));
    gaps.position.row(pair) = mesh.nodes.row(node);
    gaps.normal.row(pair) = seen[k].normal.transpose();
    gaps.node.push_back(node);
  }
  gaps.A.resize(n_pairs, unknowns.count);
  gaps.A.setFromTriplets(entries.begin(), entries.end());
  return gaps;
}

}  // namespace signorini

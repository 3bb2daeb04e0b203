#include "addons/equations/terms.hpp"

#include <cmath>

#include "signorini/core/rounding.hpp"
#include "signorini/fem/places.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {

using Eigen::Index, Eigen::Vector2d;

Vector2d place_of(const Plan& draft, Index node) {
  const BodyModel& body = draft.bodies[body_of_node(draft.bodies, node)];
  return body.mesh.nodes.row(node - body.first_node).transpose();
}

std::vector<Index> nodes_of(const Side& side, const std::optional<Vector2d>& only_at,
                            const Plan& draft) {
  const BodyModel& body = draft.bodies[body_index(draft.bodies, side)];
  std::vector<Index> nodes = nodes_at(body.mesh, side.boundary, only_at, "relation");
  for (Index& node : nodes) node += body.first_node;
  return nodes;
}

void add_to(Terms& terms, Index node, const Vector2d& along) {
  for (const int axis : {0, 1})
    if (along(axis) != 0) terms[2 * node + axis] += along(axis);
}

Equation equation_of(const Terms& terms, double right) {
  Equation row;
  row.terms.assign(terms.begin(), terms.end());
  row.right = right;
  row.rounding = 64 * epsilon * std::abs(right);
  return row;
}

}  // namespace signorini

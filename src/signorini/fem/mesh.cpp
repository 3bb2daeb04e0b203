// # Sides and boundaries of a mesh
//
// A mesh keeps cells; everything along its edge is derived from them. The side \f$s\f$ of a cell
// of \f$n\f$ corners begins at corner \f$s\f$ and ends at corner \f$s + 1\f$, with the first
// corner behind the last one. If sides have three nodes, the midpoint of side \f$s\f$ stands at
// place \f$n + s\f$ of the cell. For the cell 0, 2, 10, 8, 1, 6, 9, 5 of lattice.cpp the side 1
// has the nodes 2, 6, 10.
//
// Walking order is kept throughout. Pressures are printed along the boundary, and the normal of a
// side needs the body on the left.

#include "signorini/fem/mesh.hpp"

#include <set>

#include "signorini/core/errors.hpp"

namespace signorini {

std::vector<Eigen::Index> Mesh::side_nodes(const CellSide& side) const {
  const Eigen::Index first = cells(side.cell, side.side);
  const int n = corners(side.cell);
  const Eigen::Index last = cells(side.cell, (side.side + 1) % n);
  if (order() == MeshOrder::Linear) return {first, last};
  return {first, cells(side.cell, n + side.side), last};
}

/// A boundary is asked for by name. A name that is not there is an error at once: an empty list
/// would be a load or a support that does nothing, and a result that looks right.
const std::vector<CellSide>& boundary(const Mesh& mesh, const std::string& name) {
  const auto found = mesh.boundaries.find(name);
  if (found != mesh.boundaries.end()) return found->second;
  std::string known;
  for (const auto& [other, sides] : mesh.boundaries) known += (known.empty() ? "" : ", ") + other;
  throw ProblemError(text(
      "mesh '", mesh.name, "' has no boundary '", name,
      "'; it has: ", known.empty() ? "none; name its sides, in Gmsh by Physical Curve" : known));
}

/// Neighbouring sides share a node, which is listed once, where it is met first. On a closed
/// boundary the last side ends at the first node.
std::vector<Eigen::Index> boundary_nodes(const Mesh& mesh, const std::string& name) {
  std::vector<Eigen::Index> list;
  std::set<Eigen::Index> seen;
  for (const CellSide& side : boundary(mesh, name))
    for (const Eigen::Index node : mesh.side_nodes(side))
      if (seen.insert(node).second) list.push_back(node);
  return list;
}

}  // namespace signorini

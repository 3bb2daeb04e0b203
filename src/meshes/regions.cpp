// # Parts of a body by name
//
// A region is a list of cells, usually those of another material. It needs no nodes of its own:
// cells of two regions share the nodes of the line between them, and so they are joined. Parts
// that may separate are two bodies with a contact.

#include "meshes/regions.hpp"

#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {

using Eigen::Index;

/// A name that does not exist is usually mistyped. The message lists those that exist. Numbers of
/// cells are looked at here, because whoever cuts or refines a mesh by hand may forget them.
const std::vector<Index>& region(const Mesh& mesh, const std::string& name) {
  const auto found = mesh.regions.find(name);
  if (found == mesh.regions.end()) {
    // The list is in the order of the alphabet, as a map keeps its names.
    std::string known;
    for (const auto& [other, cells] : mesh.regions) known += (known.empty() ? "" : ", ") + other;
    throw ProblemError(text("mesh '", mesh.name, "' has no region '", name,
                            "'; it has: ", known.empty() ? "none" : known));
  }
  require_input(!found->second.empty(), "mesh '", mesh.name, "': the region '", name,
                "' has no cells");
  for (const Index cell : found->second)
    require_input(cell >= 0 && cell < mesh.n_cells(), "mesh '", mesh.name, "': the region '", name,
                  "' refers to cell ", cell, ", but the cells are 0 to ", mesh.n_cells() - 1);
  return found->second;
}

/// A cell belongs to the region if its middle does. A line of the drawing that runs through a cell
/// cannot be followed by it, and a cell belongs to one side as a whole. If the line between two
/// materials matters, cells must end on it.
Mesh with_region(Mesh mesh, const std::string& name, const Eigen::Vector2d& low,
                 const Eigen::Vector2d& high) {
  // Corners were rounded where the mesh was made, and their mean is again: a middle on the edge belongs in all units.
  const double rounding =
      8 * epsilon * (mesh.nodes.size() > 0 ? mesh.nodes.cwiseAbs().maxCoeff() : 0);
  std::vector<Index> cells;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    Eigen::Array2d middle(0, 0);
    const int n = mesh.corners(cell);
    for (int k = 0; k < n; ++k)
      middle += mesh.nodes.row(mesh.cells(cell, k)).transpose().array() / n;
    // With `<=` at both ends a middle that lies on the common line of two regions is in both.
    // Two layers of a body must not share a cell; the message then says which one they share.
    if ((middle >= low.array() - rounding).all() && (middle <= high.array() + rounding).all())
      cells.push_back(cell);
  }
  require_input(!cells.empty(), "region '", name, "' of '", mesh.name,
                "': no cell has its middle in (", low.x(), ", ", low.y(), ") to (", high.x(), ", ",
                high.y(), ')');
  mesh.regions[name] = std::move(cells);
  return mesh;
}

}  // namespace signorini

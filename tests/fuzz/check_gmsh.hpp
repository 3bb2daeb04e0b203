// What must hold for any text that is read as a Gmsh file, however odd.
#pragma once
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "addons/files/gmsh.hpp"
#include "signorini/core/errors.hpp"

namespace signorini_test {

/// Area on the left of all sides of all cells that have no neighbour in the mesh [length^2].
inline double area_by_rim(const signorini::Mesh& mesh) {
  std::set<std::pair<Eigen::Index, Eigen::Index>> rim;
  for (Eigen::Index cell = 0; cell < mesh.n_cells(); ++cell)
    for (int side = 0; side < mesh.corners(cell); ++side) {
      const std::vector<Eigen::Index> ends = mesh.side_nodes({cell, side});
      if (rim.erase({ends.back(), ends.front()}) == 0) rim.insert({ends.front(), ends.back()});
    }
  double twice = 0;
  for (const auto& [a, b] : rim)
    twice += mesh.nodes(a, 0) * mesh.nodes(b, 1) - mesh.nodes(b, 0) * mesh.nodes(a, 1);
  return twice / 2;
}

/// A mesh that was read either is refused by check_mesh() or is sound, and then its boundaries are
/// sides in walking order: as many breaks between them as there are pieces, at most.
/// \return what is wrong, or empty
inline std::string check_read(const signorini::Mesh& mesh) {
  using namespace signorini;
  if (mesh.n_cells() == 0 || mesh.n_nodes() == 0) return "a mesh without cells or nodes";
  for (Eigen::Index cell = 0; cell < mesh.n_cells(); ++cell) {
    const auto nodes = mesh.cells.row(cell).head(mesh.cell_size(cell));
    if (nodes.minCoeff() < 0 || nodes.maxCoeff() >= mesh.n_nodes()) return "node numbers";
  }
  for (const auto& [name, sides] : mesh.boundaries) {
    if (sides.empty()) return "a boundary without sides";
    for (const CellSide& side : sides)
      if (side.cell < 0 || side.cell >= mesh.n_cells() || side.side < 0 ||
          side.side >= mesh.corners(side.cell))
        return "a side that does not exist";
    if (boundary_nodes(mesh, name).empty()) return "a boundary without nodes";
  }
  try {
    check_mesh(mesh);
  } catch (const ProblemError&) {
    return "";
  }
  const double extent = mesh.nodes.cwiseAbs().maxCoeff();
  return extent > 1e150 || area_by_rim(mesh) > -1e-12 * extent * extent ? "" : "negative area";
}

/// Whether a message begins with the name and a line. \param message  of an error \return whether
inline bool names_line(const std::string& message) {
  return message.rfind("name:", 0) == 0 && message.find(": ", 5) != message.npos;
}

/// Reads a text as a Gmsh file.
/// \param content  any bytes
/// \return what is wrong, or empty; a crash or an exception of another kind is wrong as well
inline std::string check_gmsh(std::string_view content) {
  using namespace signorini;
  try {
    std::set<std::string> names;
    for (const Mesh& mesh : parse_gmsh(content, "name")) {
      const std::string wrong = check_read(mesh);
      if (!wrong.empty()) return mesh.name + ": " + wrong;
      if (!names.insert(mesh.name).second) return mesh.name + ": two meshes of one name";
    }
    return names.empty() ? "no mesh" : "";
  } catch (const ProblemError& error) {
    const std::string message = error.what();
    return names_line(message) && message.size() < 500 ? "" : "message: " + message;
  }
}

}  // namespace signorini_test

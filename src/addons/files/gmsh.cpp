#include "addons/files/gmsh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "addons/files/gmsh_boundaries.hpp"
#include "addons/files/gmsh_records.hpp"
#include "addons/text/text_reader.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/family.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/plane.hpp"

namespace signorini {
namespace {

using Eigen::Index;
/// Numbers in GmshRecords::cells, by the tag of their physical surface.
using CellsByTag = std::map<std::int64_t, std::vector<std::size_t>>;

/// Refuses nodes of cells that are not in one plane z = const.
void check_plane(const GmshRecords& file) {
  const std::array<double, 3> first = file.nodes[file.cells[0].nodes[0]].position;
  double extent = 0;
  for (const GmshElement& cell : file.cells)
    for (std::size_t k = 0; k < cell.n_nodes; ++k)
      for (std::size_t i = 0; i < 2; ++i)
        extent = std::max(extent, std::abs(file.nodes[cell.nodes[k]].position[i] - first[i]));
  for (const GmshElement& cell : file.cells)
    for (std::size_t k = 0; k < cell.n_nodes; ++k) {
      const GmshNode& node = file.nodes[cell.nodes[k]];
      require_input(std::abs(node.position[2] - first[2]) <= 1e-9 * extent, file.name, ":",
                    node.line, ": expected z = ", first[2],
                    " as of other nodes, got z = ", node.position[2],
                    "; turn the body into the plane of x and y");
    }
}

/// Refuses a file with names of curves and surfaces of which nothing in the file bears one.
void check_names(const GmshRecords& file) {
  const auto bears = [&](const GmshElement& element) { return element.groups != 0; };
  const bool any = std::any_of(file.lines.begin(), file.lines.end(), bears) ||
                   std::any_of(file.cells.begin(), file.cells.end(), bears);
  for (const auto& [group, name] : file.groups.names())
    require_input(any || (group.first != 1 && group.first != 2), file.name,
                  ":1: nothing in the file is in a physical group, not in the ",
                  group.first == 1 ? "curve" : "surface", " '", name,
                  "' either; mesh it before saving, with Mesh.SaveAll = 0 (1 loses the groups in "
                  "version 2.2), or take the names away");
}

/// Which cells are whose. Without physical surfaces all have the tag 0.
CellsByTag cells_by_tag(const GmshRecords& file) {
  CellsByTag result;
  const bool grouped = std::any_of(file.cells.begin(), file.cells.end(),
                                   [](const GmshElement& cell) { return cell.groups != 0; });
  for (std::size_t k = 0; k < file.cells.size(); ++k) {
    const GmshElement& cell = file.cells[k];
    const std::vector<std::int64_t>& tags = file.groups.tags(cell.groups);
    require_input(!grouped || !tags.empty(), file.name, ":", cell.line, ": this cell is in no ",
                  file.surface,
                  ", though others are; put its surface into one, or "
                  "set Mesh.SaveAll = 0 to leave it out");
    require_input(tags.size() <= 1, file.name, ":", cell.line, ": this cell is in ", tags.size(),
                  " ", file.surface, "s; each is a body of its own, leave it in one");
    result[grouped ? tags.front() : 0].push_back(k);
  }
  return result;
}

/// The nodes of a cell in the file, turned if its corners run clockwise.
void put_cell(const GmshRecords& file, const GmshElement& cell, CellArray::RowXpr row) {
  const auto position = [&](std::size_t k) {
    return Eigen::Vector2d(file.nodes[cell.nodes[k]].position[0],
                           file.nodes[cell.nodes[k]].position[1]);
  };
  const std::size_t n = cell.corners;
  const Eigen::Vector2d a = position(n - 2) - position(0);  // of a quadrilateral the diagonals
  const Eigen::Vector2d b = position(n - 1) - position(n == 4 ? 1 : 0);
  const bool clockwise = cross(a, b) < 0;
  for (std::size_t k = 0; k < cell.n_nodes; ++k) {
    // Backwards from the same corner: 0, n - 1, ..., 1, then the midpoints 2 n - 1, ..., n.
    const std::size_t from = !clockwise || k == 0 ? k : k < n ? n - k : 3 * n - 1 - k;
    row(static_cast<Index>(k)) = static_cast<Index>(cell.nodes[from]);
  }
}

/// The cells of a body, surface after surface.
struct SurfacesOfBody {
  std::string name;
  bool has_parts = false;
  std::vector<std::pair<std::string, std::vector<std::size_t>>> surfaces = {};  // name and cells
};

/// Which surfaces make which body.
std::vector<SurfacesOfBody> surfaces_of_bodies(const GmshRecords& file, const GmshParts& parts) {
  std::map<std::string, std::string> body_of;  // by the name of the surface
  for (const auto& [body, surfaces] : parts)
    for (const std::string& surface : surfaces) {
      const std::string& first = body_of.emplace(surface, body).first->second;
      require_input(first == body, file.name, ":1: the ", file.surface, " '", surface,
                    "' is to be part of '", first, "' and of '", body, "'; leave it in one");
    }
  std::vector<SurfacesOfBody> bodies;
  std::set<std::string> names;
  for (auto& [tag, source] : cells_by_tag(file)) {
    const std::string surface = tag == 0 ? Mesh().name : file.groups.name(2, tag);
    require_input(names.insert(surface).second, file.name, ":", file.cells[source.front()].line,
                  ": two ", file.surface, "s are named '", surface, "'; rename one");
    const auto part = body_of.find(surface);
    const std::string& name = part == body_of.end() ? surface : part->second;
    auto body = std::find_if(bodies.begin(), bodies.end(),
                             [&](const SurfacesOfBody& one) { return one.name == name; });
    if (body == bodies.end()) body = bodies.insert(bodies.end(), {name, part != body_of.end()});
    require_input(body->has_parts == (part != body_of.end()), file.name, ":",
                  file.cells[source.front()].line, ": the ", file.surface, " '", surface,
                  "' and a body of several are both named '", name, "'; rename one");
    body->surfaces.emplace_back(surface, std::move(source));
  }
  std::string known;
  for (const std::string& name : names) known += (known.empty() ? "'" : ", '") + name + "'";
  for (const auto& [surface, body] : body_of)
    require_input(names.count(surface) != 0, file.name, ":1: there is no ", file.surface, " '",
                  surface, "' for the body '", body, "'; there are: ", known);
  return bodies;
}

/// How many nodes the largest of some cells has. All must have as many nodes per side.
std::size_t width_of(const GmshRecords& file, const std::vector<std::size_t>& cells) {
  const auto per_side = [](const GmshElement& cell) { return 1 + cell.n_nodes / cell.corners; };
  const GmshElement& first = file.cells[cells.front()];
  std::size_t width = 0;
  for (const std::size_t number : cells) {
    const GmshElement& cell = file.cells[number];
    require_input(per_side(cell) == per_side(first), file.name, ":", cell.line,
                  ": expected a cell of ", per_side(first), " nodes per side as in line ",
                  first.line, ", got ", per_side(cell),
                  "; save one body with elements of one order (Mesh.ElementOrder)");
    width = std::max(width, cell.n_nodes);
  }
  return width;
}

/// Numbers the nodes of a body in the order of the file.
void number_nodes(const GmshRecords& file, GmshBody& body) {
  const Index* const data = body.file_nodes.data();
  std::vector<Index> used(data, data + body.file_nodes.size());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  if (used.front() < 0) used.erase(used.begin());  // after the nodes of triangles
  body.mesh.nodes.resize(static_cast<Index>(used.size()), 2);
  for (std::size_t k = 0; k < used.size(); ++k) {
    const GmshNode& node = file.nodes[at(used[k])];
    body.mesh.nodes.row(static_cast<Index>(k)) << node.position[0], node.position[1];
  }
  body.mesh.cells = body.file_nodes.unaryExpr([&](Index node) {
    return node < 0 ? node
                    : static_cast<Index>(std::lower_bound(used.begin(), used.end(), node) -
                                         used.begin());
  });
}

/// One body without its boundaries.
GmshBody make_body(const GmshRecords& file, const SurfacesOfBody& surfaces) {
  GmshBody body;
  body.mesh.name = surfaces.name;
  for (const auto& [name, cells] : surfaces.surfaces) {
    std::vector<Index> region(surfaces.has_parts ? cells.size() : 0);
    std::iota(region.begin(), region.end(), static_cast<Index>(body.source.size()));
    if (surfaces.has_parts) body.mesh.regions[name] = std::move(region);
    body.source.insert(body.source.end(), cells.begin(), cells.end());
  }
  const auto count = static_cast<Index>(body.source.size());
  body.file_nodes.setConstant(count, static_cast<Index>(width_of(file, body.source)), -1);
  for (Index cell = 0; cell < count; ++cell)
    put_cell(file, file.cells[body.source[at(cell)]], body.file_nodes.row(cell));
  number_nodes(file, body);
  return body;
}

}  // namespace

std::vector<Mesh> meshes_of(const GmshRecords& file, const GmshParts& parts) {
  check_plane(file);
  std::vector<GmshBody> bodies;
  for (const SurfacesOfBody& body : surfaces_of_bodies(file, parts))
    bodies.push_back(make_body(file, body));
  add_boundaries(file, bodies);
  std::vector<Mesh> meshes;
  for (GmshBody& body : bodies) meshes.push_back(std::move(body.mesh));
  return meshes;
}

std::vector<Mesh> parse_gmsh(std::string_view content, const std::string& name,
                             const GmshParts& parts) {
  const GmshRecords file = gmsh_records(content, name);
  require_input(
      !file.cells.empty(), name,
      ":1: the file has no triangles or quadrilaterals; mesh the surfaces (gmsh -2) before saving");
  check_names(file);
  return meshes_of(file, parts);
}

std::vector<Mesh> read_gmsh(const std::filesystem::path& file, const GmshParts& parts) {
  return parse_gmsh(file_content(file, largest_gmsh_file), file.string(), parts);
}

const Mesh& mesh_named(const std::vector<Mesh>& meshes, const std::string& name) {
  for (const Mesh& mesh : meshes)
    if (mesh.name == name) return mesh;
  throw ProblemError(text("there is no mesh '", name,
                          "'; there are: ", meshes.empty() ? "none" : names_of(meshes)));
}

}  // namespace signorini

#include "signorini/gmsh/gmsh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/family.hpp"
#include "signorini/core/text_reader.hpp"
#include "signorini/gmsh/gmsh_boundaries.hpp"
#include "signorini/gmsh/gmsh_records.hpp"

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
      pose(std::abs(node.position[2] - first[2]) <= 1e-9 * extent, file.name, ":", node.line,
           ": expected z = ", first[2], " as of other nodes, got z = ", node.position[2],
           "; turn the body into the plane of x and y");
    }
}

/// Refuses names of curves and surfaces that nothing in the file bears.
void check_names(const GmshRecords& file) {
  std::set<GmshGroups::Key> borne;
  const auto add = [&](int dimension, const std::vector<GmshElement>& elements) {
    for (const GmshElement& element : elements)
      for (const std::int64_t tag : file.groups.tags(element.groups))
        borne.insert({dimension, tag});
  };
  add(1, file.lines);
  add(2, file.cells);
  for (const auto& [group, name] : file.groups.names())
    pose((group.first != 1 && group.first != 2) || borne.count(group) != 0, file.name,
         ":1: nothing in the file is in the physical ", group.first == 1 ? "curve" : "surface",
         " '", name,
         "'; mesh it before saving, with Mesh.SaveAll = 0 (1 loses the groups in version",
         " 2.2), or take the name away");
}

/// Which cells are whose. Without physical surfaces all have the tag 0.
CellsByTag cells_by_tag(const GmshRecords& file) {
  CellsByTag result;
  const bool grouped = std::any_of(file.cells.begin(), file.cells.end(),
                                   [](const GmshElement& cell) { return cell.groups != 0; });
  for (std::size_t k = 0; k < file.cells.size(); ++k) {
    const GmshElement& cell = file.cells[k];
    const std::vector<std::int64_t>& tags = file.groups.tags(cell.groups);
    pose(!grouped || !tags.empty(), file.name, ":", cell.line,
         ": this cell is in no physical surface, though others are; put its surface into one, or "
         "set Mesh.SaveAll = 0 to leave it out");
    pose(tags.size() <= 1, file.name, ":", cell.line, ": this cell is in ", tags.size(),
         " physical surfaces; each is a body of its own, leave it in one");
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
  const Eigen::Vector2d a = position(2) - position(0);
  const Eigen::Vector2d b = position(3) - position(1);
  const bool clockwise = a.x() * b.y() - a.y() * b.x() < 0;
  static constexpr std::array<std::size_t, 8> same = {0, 1, 2, 3, 4, 5, 6, 7};
  static constexpr std::array<std::size_t, 8> turned = {0, 3, 2, 1, 7, 6, 5, 4};
  for (std::size_t k = 0; k < cell.n_nodes; ++k)
    row(static_cast<Index>(k)) = static_cast<Index>(cell.nodes[(clockwise ? turned : same)[k]]);
}

/// One body without its boundaries.
GmshBody make_body(const GmshRecords& file, std::string name, std::vector<std::size_t> source) {
  GmshBody body;
  body.mesh.name = std::move(name);
  body.source = std::move(source);
  const GmshElement& first = file.cells[body.source.front()];
  const auto count = static_cast<Index>(body.source.size());
  body.file_nodes.resize(count, static_cast<Index>(first.n_nodes));
  for (Index cell = 0; cell < count; ++cell) {
    const GmshElement& element = file.cells[body.source[static_cast<std::size_t>(cell)]];
    pose(element.n_nodes == first.n_nodes, file.name, ":", element.line, ": expected a cell of ",
         first.n_nodes, " nodes as in line ", first.line, ", got ", element.n_nodes,
         "; save one body with one Mesh.ElementOrder");
    put_cell(file, element, body.file_nodes.row(cell));
  }
  const Index* const data = body.file_nodes.data();
  std::vector<Index> used(data, data + body.file_nodes.size());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  body.mesh.nodes.resize(static_cast<Index>(used.size()), 2);
  for (std::size_t k = 0; k < used.size(); ++k) {
    const GmshNode& node = file.nodes[static_cast<std::size_t>(used[k])];
    body.mesh.nodes.row(static_cast<Index>(k)) << node.position[0], node.position[1];
  }
  body.mesh.cells = body.file_nodes.unaryExpr([&](Index node) {
    return static_cast<Index>(std::lower_bound(used.begin(), used.end(), node) - used.begin());
  });
  return body;
}

}  // namespace

std::vector<Mesh> parse_gmsh(std::string_view content, const std::string& name) {
  const GmshRecords file = gmsh_records(content, name);
  pose(!file.cells.empty(), name,
       ":1: the file has no quadrilaterals; mesh the surfaces (gmsh -2) ",
       "and recombine them before saving");
  check_names(file);
  check_plane(file);
  std::vector<GmshBody> bodies;
  std::set<std::string> names;
  for (auto& [tag, source] : cells_by_tag(file)) {
    const std::string body = tag == 0 ? Mesh().name : file.groups.name(2, tag);
    pose(names.insert(body).second, name, ":", file.cells[source.front()].line,
         ": two physical surfaces are named '", body, "'; rename one");
    bodies.push_back(make_body(file, body, source));
  }
  add_boundaries(file, bodies);
  std::vector<Mesh> meshes;
  for (GmshBody& body : bodies) meshes.push_back(std::move(body.mesh));
  return meshes;
}

std::vector<Mesh> read_gmsh(const std::filesystem::path& file) {
  return parse_gmsh(file_content(file, largest_gmsh_file), file.string());
}

const Mesh& mesh_named(const std::vector<Mesh>& meshes, const std::string& name) {
  for (const Mesh& mesh : meshes)
    if (mesh.name == name) return mesh;
  throw ProblemError(text("there is no mesh '", name,
                          "'; there are: ", meshes.empty() ? "none" : names_of(meshes)));
}

}  // namespace signorini

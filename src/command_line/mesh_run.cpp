#include "command_line/mesh_run.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <ostream>
#include <set>
#include <utility>

#include "addons/files/gmsh.hpp"
#include "addons/files/inp.hpp"
#include "addons/files/scene_file.hpp"
#include "command_line/print.hpp"
#include "command_line/run_monitor.hpp"
#include "command_line/scene_run.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/fem/joints.hpp"

namespace command_line {
namespace {

using namespace signorini;
using Eigen::Index;
using Sides = std::vector<CellSide>;

/// Sides that are walked along.
struct Way {
  std::string name;
  Index sides = 0;
  double length = 0;  // along the nodes
  struct Part {
    Eigen::Vector2d from, to;
  };
  std::vector<Part> parts = {};  // one after the other
};

Way way_of(const Mesh& mesh, const std::string& name, const Sides& sides) {
  Way way{name, static_cast<Index>(sides.size())};
  for (const CellSide& side : sides) {
    const std::vector<Index> nodes = mesh.side_nodes(side);
    for (std::size_t k = 1; k < nodes.size(); ++k)
      way.length += (mesh.nodes.row(nodes[k]) - mesh.nodes.row(nodes[k - 1])).norm();
  }
  Index last = -1;
  for (const CellSide& side : sides) {
    const std::vector<Index> nodes = mesh.side_nodes(side);
    const Eigen::Vector2d to = mesh.nodes.row(nodes.back());
    if (nodes.front() != last) way.parts.push_back({mesh.nodes.row(nodes.front()), to});
    last = nodes.back();
    way.parts.back().to = to;
  }
  return way;
}

/// Where the parts of a way begin and end.
std::string ends_of(const Way& way) {
  constexpr std::size_t most = 3;
  std::string all;
  for (std::size_t k = 0; k < std::min(most, way.parts.size()); ++k) {
    const auto& [from, to] = way.parts[k];
    all += (k == 0 ? "" : "; ") +
           (from == to ? "closed, from " + in_brackets(from) : in_brackets(from) + ", " + in_brackets(to));
  }
  return way.parts.size() > most ? text(all, "; ", way.parts.size() - most, " more") : all;
}

/// What is told of a mesh.
struct Facts {
  std::map<std::pair<int, Index>, Index> cells;  // how many of so many corners and nodes
  Eigen::AlignedBox2d box;
  double area = 0;  // within the nodes of each cell
  std::size_t pieces = 0;
  std::optional<MeshQuality> quality;  // nothing if the mesh cannot be taken
  std::string problem;                 // then why
  std::vector<Way> boundaries;
  Way rest;  // outer sides that are in no boundary
};

/// The area within the nodes of a cell, in the order of its outline.
double area_of(const Mesh& mesh, Index cell) {
  double twice = 0;
  for (int side = 0; side < mesh.corners(cell); ++side) {
    const std::vector<Index> nodes = mesh.side_nodes({cell, side});
    for (std::size_t k = 1; k < nodes.size(); ++k) {
      const Eigen::Vector2d a = mesh.nodes.row(nodes[k - 1]), b = mesh.nodes.row(nodes[k]);
      twice += a.x() * b.y() - a.y() * b.x();
    }
  }
  return twice / 2;
}

Facts facts_of(const Mesh& mesh) {
  Facts facts;
  try {
    facts.quality = check_mesh(mesh);
  } catch (const ProblemError& error) {
    facts.problem = error.what();
  }
  for (Index node = 0; node < mesh.n_nodes(); ++node)
    facts.box.extend(Eigen::Vector2d(mesh.nodes.row(node)));
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    ++facts.cells[{mesh.corners(cell), mesh.cell_size(cell)}];
    facts.area += area_of(mesh, cell);
  }
  facts.pieces = pieces(mesh).size();
  std::set<std::pair<Index, int>> named;
  for (const auto& [name, sides] : mesh.boundaries) {
    facts.boundaries.push_back(way_of(mesh, name, sides));
    for (const CellSide& side : sides) named.insert({side.cell, side.side});
  }
  if (!facts.quality) return facts;
  Sides rest = outer_sides(mesh);
  rest.erase(std::remove_if(rest.begin(), rest.end(),
                            [&](const CellSide& side) {
                              return named.count({side.cell, side.side}) != 0;
                            }),
             rest.end());
  facts.rest = way_of(mesh, "", rest);
  return facts;
}

void print_ways(std::ostream& out, const Facts& facts) {
  std::size_t width = 8;
  for (const Way& way : facts.boundaries) width = std::max(width, way.name.size());
  const auto row = [&](const std::string& name, const std::string& sides, const std::string& length,
                       const std::string& where) {
    out << "  " << name << std::string(width - name.size(), ' ')
        << std::string(8 - std::min<std::size_t>(8, sides.size()), ' ') << sides
        << std::string(12 - std::min<std::size_t>(12, length.size()), ' ') << length << "  "
        << where << '\n';
  };
  if (facts.boundaries.empty() && facts.rest.sides == 0) return;
  row("boundary", "sides", "length", "from, to");
  for (const Way& way : facts.boundaries)
    row(way.name, std::to_string(way.sides), number(way.length, "%.6g"),
        ends_of(way));
  if (facts.rest.sides > 0)
    row("none", std::to_string(facts.rest.sides), number(facts.rest.length, "%.6g"), "");
}

void print_mesh(std::ostream& out, const Mesh& mesh) {
  const Facts facts = facts_of(mesh);
  out << "\nbody '" << mesh.name << "': " << mesh.n_nodes() << " nodes";
  for (const auto& [kind, count] : facts.cells)
    out << ", " << count << (kind.first == 3 ? " triangle" : " quadrilateral")
        << (count == 1 ? "" : "s") << " of " << kind.second << " nodes";
  out << "\n  box " << in_brackets(facts.box.min()) << ", " << in_brackets(facts.box.max())
      << ", area " << number(facts.area, "%.6g") << ", " << facts.pieces
      << (facts.pieces == 1 ? " piece" : " pieces") << '\n';
  if (facts.quality)
    out << "  quality, 1 is best: smallest ratio of Jacobians "
        << number(facts.quality->smallest_jacobian_ratio, "%.3g") << ", largest of sides "
        << number(facts.quality->largest_aspect_ratio, "%.3g") << '\n';
  else
    out << "  cannot be taken: " << facts.problem << '\n';
  print_ways(out, facts);
  for (const auto& [name, cells] : mesh.regions)
    out << "  region '" << name << "': " << cells.size()
        << (cells.size() == 1 ? " cell\n" : " cells\n");
}

void write_way(Json& json, const Way& way) {
  json.key("sides").value(way.sides).key("length").value(way.length);
}

void write_ends(Json& json, const Way::Part& part) {
  json.key("from").value(Eigen::VectorXd(part.from)).key("to").value(Eigen::VectorXd(part.to));
}

void write_boundary(Json& json, const Way& way) {
  json.object().key("name").value(way.name);
  write_way(json, way);
  if (!way.parts.empty()) write_ends(json, {way.parts.front().from, way.parts.back().to});
  json.key("parts").array();
  for (const Way::Part& part : way.parts) {
    write_ends(json.object(), part);
    json.end();
  }
  json.end().end();
}

void write_mesh(Json& json, const Mesh& mesh) {
  const Facts facts = facts_of(mesh);
  json.object().key("name").value(mesh.name).key("nodes").value(mesh.n_nodes());
  json.key("cells").array();
  for (const auto& [kind, count] : facts.cells) {
    json.object().key("corners").value(Index{kind.first}).key("nodes").value(kind.second);
    json.key("count").value(count).end();
  }
  json.end().key("pieces").value(static_cast<Index>(facts.pieces));
  json.key("low").value(Eigen::VectorXd(facts.box.min()));
  json.key("high").value(Eigen::VectorXd(facts.box.max())).key("area").value(facts.area);
  if (facts.quality) {
    json.key("jacobian_ratio").value(facts.quality->smallest_jacobian_ratio);
    json.key("aspect_ratio").value(facts.quality->largest_aspect_ratio);
    json.key("unnamed").object();
    write_way(json, facts.rest);
    json.end();
  } else {
    json.key("problem").value(facts.problem);
  }
  json.key("boundaries").array();
  for (const Way& way : facts.boundaries) write_boundary(json, way);
  json.end().key("regions").array();
  for (const auto& [name, cells] : mesh.regions)
    json.object()
        .key("name")
        .value(name)
        .key("cells")
        .value(static_cast<Index>(cells.size()))
        .end();
  json.end().end();
}

}  // namespace

MeshRun read_meshes(const std::string& file) {
  MeshRun run;
  run.name = file == "-" ? standard_input : file;
  const Progress progress(text("reading ", run.name));
  const std::string content = content_of(file, largest_gmsh_file);
  if (content.find("[[body]]") != std::string::npos) {
    SceneFile scene = parse_scene(content, run.name, folder_of(file));
    for (Body& body : scene.scene.bodies) run.meshes.push_back(std::move(body.mesh));
    run.files = std::move(scene.files);
  } else if (std::filesystem::path(file).extension() == ".inp" || is_inp(content)) {
    InpMeshes read = parse_inp(content, run.name);
    run.meshes = std::move(read.meshes);
    run.unread = std::move(read.unread);
    run.further_sets = std::move(read.further_sets);
    run.notes = std::move(read.notes);
  } else {
    run.meshes = parse_gmsh(content, run.name);
  }
  run.files.emplace_back(file);
  return run;
}

bool usable(const MeshRun& run) {
  return std::all_of(run.meshes.begin(), run.meshes.end(),
                     [](const Mesh& mesh) { return facts_of(mesh).quality.has_value(); });
}

void print(std::ostream& out, const MeshRun& run) {
  out << run.name << ": " << run.meshes.size() << (run.meshes.size() == 1 ? " body" : " bodies")
      << '\n';
  for (const Mesh& mesh : run.meshes) print_mesh(out, mesh);
  if (!run.further_sets.empty())
    out << "\nfurther element sets, for set = \"NAME\": " << listed(run.further_sets) << '\n';
  if (!run.unread.empty()) out << "\nnot read: " << listed(run.unread) << '\n';
  if (!run.notes.empty()) out << '\n';
  for (const std::string& note : run.notes) out << "note  " << note << '\n';
}

void write(Json& json, const MeshRun& run) {
  begin_document(json, "mesh");
  json.key("file").value(run.name).key("bodies").array();
  for (const Mesh& mesh : run.meshes) write_mesh(json, mesh);
  json.end().key("further_sets").value(run.further_sets).key("unread").value(run.unread);
  json.key("notes").value(run.notes);
  json.end();
}

}  // namespace command_line

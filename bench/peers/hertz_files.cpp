#include "bench/peers/hertz_files.hpp"

#include <cmath>
#include <sstream>

#include "signorini/core/table.hpp"
#include "signorini/report/results.hpp"

namespace signorini::bench {
namespace {

using Eigen::Index;

/// Calls a function with every body of a case and the numbers that its first node and cell have in a file.
template <typename Visit>
void each_body(const HertzCase& now, Visit&& visit) {
  Index node = 1, cell = 1;
  for (const Body& body : now.scene.bodies) {
    visit(body, node, cell);
    node += body.mesh.n_nodes();
    cell += body.mesh.n_cells();
  }
}

/// A node. \param format  of both coordinates \param between  them
std::string place(const Eigen::Vector2d& x, const char* format, const char* between) {
  return number(x.x(), format) + between + number(x.y(), format) + between + "0\n";
}

/// The physical groups of a mesh, and its lines or cells as records of Gmsh.
struct GmshGroups {
  std::ostringstream names, records;
  Index n_names = 0, n_records = 0;

  int name(int dimension, const std::string& called) {
    names << dimension << ' ' << ++n_names << " \"" << called << "\"\n";
    return static_cast<int>(n_names);
  }
  void record(int kind, int group, const std::string& nodes) {
    records << ++n_records << ' ' << kind << " 2 " << group << ' ' << group << nodes << '\n';
  }
};

/// Node numbers of a file. \param nodes  of a mesh \param first  number of its first \param before  each number
template <typename Nodes>
std::string numbers(const Nodes& nodes, Index first, const char* before) {
  std::string all;
  for (const Index node : nodes) all += before + std::to_string(first + node);
  return all;
}

}  // namespace

void write_gmsh_file(const HertzCase& now) {
  std::ostringstream nodes;
  GmshGroups groups;
  each_body(now, [&](const Body& body, Index node, Index) {
    const Mesh& mesh = body.mesh;
    for (Index k = 0; k < mesh.n_nodes(); ++k)
      nodes << node + k << ' ' << place(mesh.nodes.row(k), "%.17g", " ");
    for (const auto& [boundary, sides] : mesh.boundaries) {
      const int group = groups.name(1, mesh.name + "_" + boundary);
      for (const CellSide& side : sides)
        groups.record(1, group, numbers(mesh.side_nodes(side), node, " "));
    }
    const int group = groups.name(2, mesh.name);
    for (Index c = 0; c < mesh.n_cells(); ++c)
      groups.record(3, group, numbers(mesh.cells.row(c), node, " "));
  });
  std::ostringstream file;
  file << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n"
       << groups.n_names << '\n'
       << groups.names.str() << "$EndPhysicalNames\n$Nodes\n"
       << now.n_nodes() << '\n'
       << nodes.str() << "$EndNodes\n$Elements\n"
       << groups.n_records << '\n'
       << groups.records.str() << "$EndElements\n";
  write_file(now.folder / "hertz.msh", file.str());
}

void write_scene_file(const HertzCase& now) {
  const signorini_test::HertzProblem& problem = now.problem;
  std::ostringstream file;
  file << "title = \"Hertz: a cylinder on a plate\"\n";
  for (const Body& body : now.scene.bodies) {
    const std::string& name = body.mesh.name;
    file << "\n[[body]]\nname = \"" << name << "\"\nelement = \"" << body.element
         << "\"\nmesh = { kind = \"gmsh\", file = \"hertz.msh\", surface = \"" << name
         << "\" }\nmaterial = { youngs_modulus = " << shortest(body.material.youngs_modulus)
         << ", poisson_ratio = " << shortest(body.material.poisson_ratio) << " }\nsymmetric = \""
         << name << "_axis\"\n";
    if (name == "plate") file << "fixed = \"plate_base\"\n";
    for (const auto& load : body.loads.edges)
      file << "pressure = { " << name << '_' << load.boundary << " = " << shortest(load.pressure)
           << " }\n";
  }
  file << "\n[[contact]]\nsource = \"disc.disc_rim\"\ntarget = \"plate.plate_surface\"\n"
       << "operator = \"" << problem.gap_operator << "\"\n";
  write_file(now.folder / "hertz.toml", file.str());
}

void write_calculix_file(const HertzCase& now, const std::string& name,
                         const CalculixContact& contact) {
  const LineContact theory = now.problem.theory();
  const double overlap = std::pow(hertz_half_width(theory), 2) / (2 * theory.radius);
  std::ostringstream file, loads;
  each_body(now, [&](const Body& body, Index node, Index cell) {
    const Mesh& mesh = body.mesh;
    const Eigen::RowVector2d up(0, contact.overlap && mesh.name == "plate" ? overlap : 0);
    file << "*NODE\n";
    for (Index k = 0; k < mesh.n_nodes(); ++k)  // its fields have 20 letters
      file << node + k << ',' << place(mesh.nodes.row(k) + up, "%.13g", ",");
    file << "*ELEMENT,TYPE=CPE4,ELSET=" << mesh.name << '\n';
    for (Index c = 0; c < mesh.n_cells(); ++c)
      file << cell + c << numbers(mesh.cells.row(c), node, ",") << '\n';
    for (const auto& [boundary, sides] : mesh.boundaries) {
      file << "*SURFACE,TYPE=ELEMENT,NAME=" << mesh.name << '_' << boundary << '\n';
      for (const CellSide& side : sides) file << cell + side.cell << ",S" << side.side + 1 << '\n';
      file << "*NSET,NSET=" << mesh.name << '_' << boundary << "_nodes";
      for (const Index k : boundary_nodes(mesh, boundary)) file << '\n' << node + k << ',';
      file << '\n';
    }
    file << "*MATERIAL,NAME=of_" << mesh.name << "\n*ELASTIC\n"
         << shortest(body.material.youngs_modulus) << ',' << shortest(body.material.poisson_ratio)
         << "\n*SOLID SECTION,ELSET=" << mesh.name << ",MATERIAL=of_" << mesh.name << "\n1\n"
         << "*BOUNDARY\n"
         << mesh.name << "_axis_nodes,1,1\n";
    if (mesh.name == "plate") file << "plate_base_nodes,1,2\n";
    for (const auto& load : body.loads.edges)
      for (const CellSide& side : boundary(mesh, load.boundary))
        loads << cell + side.cell << ",P" << side.side + 1 << ',' << shortest(load.pressure)
              << '\n';
  });
  const double stiffness = contact.stiffness * now.problem.disc_modulus;
  file << "*SURFACE INTERACTION,NAME=touch\n*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR\n"
       << shortest(stiffness) << "\n*CONTACT PAIR,INTERACTION=touch,TYPE=" << contact.type
       << "\ndisc_rim,plate_surface\n*STEP,INC=1000\n*STATIC\n1,1\n*DLOAD\n"
       << loads.str() << "*CONTACT FILE,OUTPUT=3D\nCDIS,CSTR\n*END STEP\n";
  write_file(now.folder / (name + ".inp"), file.str());
}

}  // namespace signorini::bench

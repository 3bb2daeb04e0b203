#include "bench/peers/hertz_programs.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "bench/peers/child.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"

namespace signorini::bench {
namespace {

using Eigen::Index;

/// Lines of a file that a program wrote.
std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  require_input(in.good(), "it wrote no ", file.filename().string());
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// Numbers of a line between commas, the words among them as 0.
std::vector<double> fields(const std::string& line) {
  std::vector<double> all;
  std::istringstream in(line);
  for (std::string word; std::getline(in, word, ',');)
    all.push_back(std::strtod(word.c_str(), nullptr));
  return all;
}

/// Rows of numbers, with x and the force in two of their columns, below a line of names.
RimForces read_columns(const std::filesystem::path& file, std::size_t x, std::size_t force) {
  RimForces rim;
  for (const std::string& line : lines_of(file)) {
    if (line.empty() || line[0] == '#' || line[0] == 'x') continue;
    const std::vector<double> row = fields(line);
    require_input(row.size() > std::max(x, force), file.filename().string(),
                  ": a line has too few columns");
    rim.x.push_back(row[x]);
    rim.force.push_back(row[force]);
  }
  require_input(!rim.x.empty(), file.filename().string(), " has no rows");
  return rim;
}

Program ours(const std::string& own) {
  Program program{"signorini", "signorini", "", write_scene_file, {}, {}};
  program.command = [own](const HertzCase&) {
    return std::vector<std::string>{own, "solve", "hertz.toml", "--csv", "signorini.csv"};
  };
  program.read = [](const HertzCase& now) {
    RimForces rim = read_columns(now.folder / "signorini.csv", 0, 4);
    for (const std::string& line : lines_of(now.folder / "signorini.log")) {
      const std::size_t at = line.find("  iterations ");
      if (line.rfind("contact ", 0) == 0 && at != line.npos)
        rim.iterations = std::strtol(line.c_str() + at + 13, nullptr, 10);
    }
    return rim;
  };
  return program;
}

Program getfem(const std::string& script) {
  const std::vector<std::string> pythons = pythons_with("getfem");
  Program program{"GetFEM, nodal", "getfem", "", [](const HertzCase&) {}, {}, {}};
  if (pythons.empty()) {
    program.missing = "not installed (Debian package python3-getfem)";
    return program;
  }
  program.command = [script, python = pythons[0]](const HertzCase& now) {
    const Body& disc = now.scene.bodies[0];
    return std::vector<std::string>{python, script, shortest(disc.material.youngs_modulus),
                                    shortest(disc.material.poisson_ratio),
                                    shortest(disc.loads.edges[0].pressure)};
  };
  program.read = [](const HertzCase& now) {
    RimForces rim = read_columns(now.folder / "getfem.csv", 0, 1);
    const std::string first = lines_of(now.folder / "getfem.csv")[0];  // # iterations N
    rim.iterations = std::strtol(first.c_str() + std::string("# iterations ").size(), nullptr, 10);
    return rim;
  };
  return program;
}

/// Pressures of CalculiX at nodes, from the last result of a kind in its file of fixed columns.
struct Frd {
  std::map<long, Eigen::Vector2d> place;
  std::map<long, double> pressure;

  explicit Frd(const std::filesystem::path& file) {
    enum class Block { Other, Nodes, Contact } block = Block::Other;
    for (const std::string& line : lines_of(file)) {
      const std::string key = line.substr(0, 3), what = line.substr(0, 13);
      if (what.rfind("    2C", 0) == 0) block = Block::Nodes;
      if (what == " -4  CONTACT ") {
        block = Block::Contact;
        pressure.clear();
      }
      if (key == " -3") block = Block::Other;
      if (key != " -1" || block == Block::Other) continue;
      const auto value = [&line](std::size_t k) {  // in twelve letters each
        return std::strtod(line.substr(13 + 12 * k, 12).c_str(), nullptr);
      };
      const long node = std::strtol(line.substr(3, 10).c_str(), nullptr, 10);
      if (block == Block::Nodes)
        place[node] = {value(0), value(1)};
      else
        pressure[node] = value(3);
    }
  }
};

/// Forces from pressures at nodes of the rim. In the body of unit thickness that CalculiX makes of plane elements
/// they may be asked for on both faces: the mean counts.
RimForces read_frd(const HertzCase& now, const std::string& name) {
  const Frd frd(now.folder / (name + ".frd"));
  const Rim rim = rim_of(now);
  std::vector<double> sum(static_cast<std::size_t>(rim.weight.size()));
  std::vector<int> faces(sum.size());
  for (const auto& [node, pressure] : frd.pressure) {
    if (pressure == 0) continue;
    const auto at = frd.place.find(node);
    require_input(at != frd.place.end(), name, ".frd: node ", node, " with a pressure is nowhere");
    Index k = 0;
    const double distance =
        (rim.place.rowwise() - at->second.transpose()).rowwise().norm().minCoeff(&k);
    require_input(distance <= 0.1 * rim.weight(k), name, ".frd: node ", node,
                  " with a pressure is not on the rim");
    sum[static_cast<std::size_t>(k)] += pressure;
    ++faces[static_cast<std::size_t>(k)];
  }
  RimForces result;
  for (std::size_t k = 0; k < sum.size(); ++k) {
    const auto row = static_cast<Index>(k);
    result.x.push_back(rim.place(row, 0));
    result.force.push_back(faces[k] == 0 ? 0 : sum[k] / faces[k] * rim.weight(row));
  }
  for (const std::string& line : lines_of(now.folder / (name + ".sta"))) {
    std::istringstream words(line);
    Index step = 0, increment = 0, attempt = 0, iterations = 0;
    if (words >> step >> increment >> attempt >> iterations) result.iterations += iterations;
  }
  return result;
}

Program calculix(const std::string& name, const std::string& file, CalculixContact contact) {
  Program program{name, file, "", {}, {}, {}};
  if (!is_program("ccx")) program.missing = "not installed (Debian package calculix-ccx)";
  program.prepare = [file, contact](const HertzCase& now) {
    write_calculix_file(now, file, contact);
  };
  program.command = [file](const HertzCase&) { return std::vector<std::string>{"ccx", file}; };
  program.read = [file](const HertzCase& now) { return read_frd(now, file); };
  return program;
}

}  // namespace

Rim rim_of(const HertzCase& now) {
  const Mesh& disc = now.scene.bodies[0].mesh;
  std::vector<Index> nodes = boundary_nodes(disc, "rim");
  std::sort(nodes.begin(), nodes.end(),
            [&](Index a, Index b) { return disc.nodes(a, 0) < disc.nodes(b, 0); });
  const auto n = static_cast<Index>(nodes.size());
  Rim rim{Eigen::MatrixX2d(n, 2), Eigen::VectorXd::Zero(n)};
  for (Index k = 0; k < n; ++k)
    rim.place.row(k) = disc.nodes.row(nodes[static_cast<std::size_t>(k)]);
  for (Index k = 0; k + 1 < n; ++k)
    rim.weight.segment(k, 2).array() += (rim.place.row(k + 1) - rim.place.row(k)).norm() / 2;
  return rim;
}

std::vector<Program> hertz_programs(const std::string& own, const std::string& script) {
  return {
      ours(own), getfem(script),
      calculix("CalculiX, surface to surface", "ccx_surface", {"SURFACE TO SURFACE", 1000, true}),
      calculix("CalculiX, node to surface", "ccx_node", {"NODE TO SURFACE", 50, false})};
}

}  // namespace signorini::bench

#include <Eigen/Geometry>
#include <algorithm>
#include <sstream>

#include "command_line/mesh_run.hpp"
#include "signorini/core/errors.hpp"

namespace command_line {
namespace {

using namespace signorini;
using Eigen::Index;

constexpr double picture_width = 720;  // of the picture [pixels]
constexpr double key_row = 24;         // of the key [pixels]

/// The outlines of the cells, closed, each by itself.
std::string cells_of(const Mesh& mesh) {
  std::ostringstream all;
  const auto put = [&](Index node) {
    all << mesh.nodes(node, 0) << ',' << mesh.nodes(node, 1) << '\n';
  };
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    for (int side = 0; side < mesh.corners(cell); ++side) {
      const std::vector<Index> nodes = mesh.side_nodes({cell, side});
      std::for_each(nodes.begin(), nodes.end() - 1, put);
    }
    put(mesh.cells(cell, 0));
    all << '\n';
  }
  return all.str();
}

/// The sides of a boundary, each by itself.
std::string sides_of(const Mesh& mesh, const std::vector<CellSide>& sides) {
  std::ostringstream all;
  for (const CellSide& side : sides) {
    for (const Index node : mesh.side_nodes(side))
      all << mesh.nodes(node, 0) << ',' << mesh.nodes(node, 1) << '\n';
    all << '\n';
  }
  return all.str();
}

}  // namespace

void draw(const std::filesystem::path& file, PictureKind kind, const MeshRun& run) {
  Eigen::AlignedBox2d box;
  std::ostringstream data, plot;
  Index n_cells = 0;
  int ways = 0;
  for (const Mesh& mesh : run.meshes) {
    for (Index node = 0; node < mesh.n_nodes(); ++node)
      box.extend(Eigen::Vector2d(mesh.nodes.row(node)));
    n_cells += mesh.n_cells();
  }
  data << "$cells << EOD\n";
  for (const Mesh& mesh : run.meshes) data << cells_of(mesh);
  data << "EOD\n";
  for (const Mesh& mesh : run.meshes)
    for (const auto& [name, sides] : mesh.boundaries) {
      data << "$way" << ++ways << " << EOD\n" << sides_of(mesh, sides) << "EOD\n";
      plot << ", $way" << ways << " using 1:2 with lines lt " << ways << " lw 3 title "
           << for_gnuplot(mesh.name + "." + name) << " noenhanced";
    }
  const double key = key_row * ways + 20;
  const double flat = box.sizes().y() / std::max(box.sizes().x(), 1e-300);
  const double height = std::clamp(600 * flat, 80.0, 900.0) + 80 + key;
  const double tics = round_down(box.sizes().maxCoeff() / 4);
  constexpr Index most_outlined = 40000;  // beyond that, outlines are all there is to see
  std::ostringstream gp;
  gp << picture_head(file, kind, picture_width, height) << data.str()
     << "set size ratio -1\nunset grid\nset xlabel 'x'\nset ylabel 'y'\nset xtics " << tics
     << "\nset ytics " << tics << "\nset xrange " << range(box.min().x(), box.max().x())
     << "\nset yrange " << range(box.min().y(), box.max().y()) << "\nset key at screen 0.5, screen "
     << (height - 8) / height
     << " center top maxcols 1 Left reverse noopaque\nset tmargin at screen "
     << (height - key) / height << "\nplot $cells using 1:2 with polygons fc rgb LIGHT notitle";
  if (n_cells <= most_outlined) gp << ", '' using 1:2 with lines lw 0.4 lc rgb GREY notitle";
  gp << plot.str() << "\nset output\n";
  run_gnuplot(file, gp.str());
}

}  // namespace command_line

// Areas, lengths and walks of meshes, curved sides included.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "signorini/fem/mesh.hpp"

namespace signorini_test {

/// Integral of f(x, dx/dt) over the sides of t from -1 to 1, by two Gauss points: exact for areas.
template <typename Function>
double along_side(const signorini::Mesh& mesh, const signorini::CellSide& side, Function&& f) {
  const std::vector<Eigen::Index> nodes = mesh.side_nodes(side);
  const Eigen::RowVector2d a = mesh.nodes.row(nodes.front());
  const Eigen::RowVector2d b = mesh.nodes.row(nodes.back());
  const Eigen::RowVector2d middle = nodes.size() == 3 ? Eigen::RowVector2d(mesh.nodes.row(nodes[1]))
                                                      : Eigen::RowVector2d(0.5 * (a + b));
  const Eigen::RowVector2d bend = 0.5 * (a + b) - middle;
  double sum = 0;
  for (const double t : {-std::sqrt(1.0 / 3), std::sqrt(1.0 / 3)})
    sum += f(Eigen::RowVector2d(middle + 0.5 * t * (b - a) + t * t * bend),
             Eigen::RowVector2d(0.5 * (b - a) + 2 * t * bend));
  return sum;
}

/// Area of all cells; cells that run clockwise count negative.
inline double area_of(const signorini::Mesh& mesh) {
  double area = 0;
  for (Eigen::Index cell = 0; cell < mesh.n_cells(); ++cell)
    for (int side = 0; side < mesh.corners(cell); ++side)
      area += along_side(mesh, {cell, side},
                         [](const Eigen::RowVector2d& x, const Eigen::RowVector2d& along) {
                           return 0.5 * (x.x() * along.y() - x.y() * along.x());
                         });
  return area;
}

inline double length_of(const signorini::Mesh& mesh, const std::string& name) {
  double length = 0;
  for (const signorini::CellSide& side : signorini::boundary(mesh, name))
    length += along_side(
        mesh, side,
        [](const Eigen::RowVector2d&, const Eigen::RowVector2d& along) { return along.norm(); });
  return length;
}

/// How many nodes a mesh without holes has if no two are in one place: by Euler, corners - sides + cells = 1.
inline Eigen::Index nodes_if_joined(const signorini::Mesh& mesh,
                                    const std::vector<std::string>& rim) {
  Eigen::Index ends = 0;  // every side inside has two cells
  for (Eigen::Index cell = 0; cell < mesh.n_cells(); ++cell) ends += mesh.corners(cell);
  for (const std::string& name : rim)
    ends += static_cast<Eigen::Index>(signorini::boundary(mesh, name).size());
  const Eigen::Index corners = 1 + ends / 2 - mesh.n_cells();
  return mesh.order() == signorini::MeshOrder::Quadratic ? corners + ends / 2 : corners;
}

/// Whether the boundaries in this order are one walk once round, each side beginning where the last
/// one ended, round an area that is that of all cells: so the body is to the left, and nothing of
/// its rim is missing.
inline bool is_rim(const signorini::Mesh& mesh, const std::vector<std::string>& names) {
  double area = 0;
  Eigen::Index before = mesh.side_nodes(signorini::boundary(mesh, names.back()).back()).back();
  for (const std::string& name : names)
    for (const signorini::CellSide& side : signorini::boundary(mesh, name)) {
      if (mesh.side_nodes(side).front() != before) return false;
      before = mesh.side_nodes(side).back();
      area +=
          along_side(mesh, side, [](const Eigen::RowVector2d& x, const Eigen::RowVector2d& along) {
            return 0.5 * (x.x() * along.y() - x.y() * along.x());
          });
    }
  const double whole = area_of(mesh);
  return std::abs(area - whole) < 1e-12 * std::abs(whole);
}

/// Whether every node has a partner exactly where `image` sends it.
template <typename Image>
bool is_symmetric(const signorini::Mesh& mesh, Image&& image) {
  std::vector<std::pair<double, double>> here;
  std::vector<std::pair<double, double>> there;
  for (Eigen::Index node = 0; node < mesh.n_nodes(); ++node) {
    const Eigen::RowVector2d x = mesh.nodes.row(node);
    const Eigen::RowVector2d y = image(x);
    here.emplace_back(x.x(), x.y());
    there.emplace_back(y.x(), y.y());
  }
  std::sort(here.begin(), here.end());
  std::sort(there.begin(), there.end());
  return here == there;
}

}  // namespace signorini_test

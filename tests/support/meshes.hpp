// Meshes for the tests of the elements.
#pragma once
#include <cmath>

#include "meshes/split.hpp"
#include "meshes/block.hpp"
#include "signorini/fem/element.hpp"
#include "signorini/fem/unknowns.hpp"
#include "support/random.hpp"

namespace signorini_test {

inline signorini::MeshOrder order_of(const signorini::Element& element) {
  return element.n_nodes > 4 ? signorini::MeshOrder::Quadratic : signorini::MeshOrder::Linear;
}

/// Cells of as many corners as `element` has: triangles from pairs.
inline signorini::Mesh fitting(const signorini::Mesh& mesh, const signorini::Element& element) {
  return element.corners() == 3 ? split(mesh) : mesh;
}

/// A rectangle from the origin for the cells of `element`.
inline signorini::Mesh block_for(const signorini::Element& element, Eigen::Vector2d size,
                                 Eigen::Index cells_x, Eigen::Index cells_y) {
  return fitting(signorini::block("block", {0, 0}, size, cells_x, cells_y, order_of(element)),
                 element);
}

/// Moves the inner corners by up to a fifth of a cell; midside nodes follow, so that sides stay straight.
inline signorini::Mesh distorted(signorini::Mesh mesh, Eigen::Vector2d size,
                                 Eigen::Vector2d cell_size, std::uint64_t seed) {
  Random random(seed);
  for (Eigen::Index node = 0; node < mesh.n_nodes(); ++node) {
    const double x = mesh.nodes(node, 0);
    const double y = mesh.nodes(node, 1);
    const Eigen::RowVector2d shift(random.uniform(-0.2, 0.2) * cell_size.x(),
                                   random.uniform(-0.2, 0.2) * cell_size.y());
    const bool inside = x > 1e-9 && x < size.x() - 1e-9 && y > 1e-9 && y < size.y() - 1e-9;
    if (inside) mesh.nodes.row(node) += shift;
  }
  if (mesh.order() == signorini::MeshOrder::Linear) return mesh;
  for (Eigen::Index cell = 0; cell < mesh.n_cells(); ++cell)
    for (int n = mesh.corners(cell), side = 0; side < n; ++side)
      mesh.nodes.row(mesh.cells(cell, n + side)) =
          0.5 * (mesh.nodes.row(mesh.cells(cell, side)) +
                 mesh.nodes.row(mesh.cells(cell, (side + 1) % n)));
  return mesh;
}

/// Corners of a general quadrilateral or triangle and, for 8 or 6 nodes, midside nodes near but not at the middle.
inline signorini::CellNodes distorted_cell(const signorini::Element& element) {
  signorini::CellNodes nodes(element.n_nodes, 2);
  nodes.row(0) << 0.1, -0.2;
  nodes.row(1) << 2.3, 0.1;
  nodes.row(2) << 1.9, 1.7;
  const int n = element.corners();
  if (n == 4) nodes.row(3) << -0.3, 1.2;
  for (int side = 0; side < n && order_of(element) == signorini::MeshOrder::Quadratic; ++side)
    nodes.row(n + side) = 0.5 * (nodes.row(side) + nodes.row((side + 1) % n)) +
                          Eigen::RowVector2d(0.05 - 0.03 * side, 0.02 * side - 0.04);
  return nodes;
}

/// Every displacement on the four sides of a block is given by `field`.
inline std::vector<signorini::Support> given_around(const signorini::VectorField& field) {
  std::vector<signorini::Support> supports;
  for (const char* side : {"bottom", "right", "top", "left"})
    supports.push_back({side, true, true, field, false});
  return supports;
}

}  // namespace signorini_test

// # What a cell hands to its element
//
// An element sees positions, a matrix \f$D\f$ and a depth. It sees no mesh, no unknowns and no
// boundary, so that the same function serves assembly, stresses, eigenstrains and error estimates.
//
// Positions are counted from the middle of the cell. Only differences of positions enter strains.
// At a distance of \f$10^6\f$ cell sizes from the origin a difference of rounded products would
// lose six digits, and a difference of coordinates, taken first, loses none that the mesh still
// has.

#include "signorini/fem/cells.hpp"

#include "signorini/fem/elements.hpp"

namespace signorini {

using Eigen::Index;

Eigen::Vector2d position(const Cell& cell, const StrainPoint& point) {
  return cell.body.position(cell.element.shape(point.local.x(), point.local.y()).value);
}

CellNodes cell_nodes(const Mesh& mesh, Index cell) {
  CellNodes nodes(mesh.cell_size(cell), 2);
  for (Index k = 0; k < nodes.rows(); ++k) nodes.row(k) = mesh.nodes.row(mesh.cells(cell, k));
  return nodes;
}

/// A mesh may mix shapes. The user names the element of the quadrilaterals, and there is only one
/// triangle that fits beside each of them.
/// Both are made once, because cells keep a reference. They are named here and not looked up, so
/// that assembly does not bring the table of all elements along.
const Element& triangle_beside(const Mesh& mesh) {
  static const Element linear = t3();
  static const Element quadratic = t6();
  return mesh.order() == MeshOrder::Linear ? linear : quadratic;
}

CellBody cell_body(const CellNodes& nodes, const Elasticity& D, const Depth& depth) {
  CellBody body{arms_from_middle(nodes), {}, D, depth};
  body.middle = (nodes.row(0) - body.arms.row(0)).transpose();
  return body;
}

std::vector<Elasticity> elasticity_matrices(const MaterialField& material) {
  std::vector<Elasticity> D = {elasticity_matrix(material.base)};
  for (const Material& other : material.others) D.push_back(elasticity_matrix(other));
  return D;
}

/// What all cells share is computed once: their matrices \f$D\f$, one per material. Of each cell
/// nothing is kept. It is made when it is asked for, from its nodes and the number of its material,
/// so that several threads may ask at the same time. A list of numbers that belongs to another mesh
/// would be read beyond its end.
Cells::Cells(const Mesh& mesh, const Element& element, const MaterialField& material)
    : mesh_(mesh),
      element_(element),
      triangle_(element.corners() == 3 ? element : triangle_beside(mesh)),
      material_(material),
      D_(elasticity_matrices(material)),
      depth_(depth_of(material)) {
  const std::size_t known = material.number_of.size();
  require_argument(known == 0 || known == static_cast<std::size_t>(mesh.n_cells()), "cells of '",
                   mesh.name, "': there are ", mesh.n_cells(), ", but the materials are those of ",
                   known);
}

CellVector gathered(const Cell& cell, const NodeArray& displacements) {
  CellVector u(2 * cell.element.n_nodes);
  for (Index k = 0; k < cell.element.n_nodes; ++k)
    u.segment<2>(2 * k) = displacements.row(cell.node(k)).transpose();
  return u;
}

}  // namespace signorini

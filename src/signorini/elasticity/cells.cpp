#include "signorini/elasticity/cells.hpp"

namespace signorini {

using Eigen::Index;

CellNodes cell_nodes(const Mesh& mesh, Index cell) {
  CellNodes nodes(mesh.cells.cols(), 2);
  for (Index k = 0; k < mesh.cells.cols(); ++k) nodes.row(k) = mesh.nodes.row(mesh.cells(cell, k));
  return nodes;
}

CellBody cell_body(const CellNodes& nodes, const Elasticity& D, const Depth& depth) {
  CellBody body{arms_from_middle(nodes), {}, D, depth};
  body.middle = (nodes.row(0) - body.arms.row(0)).transpose();
  return body;
}

CellVector gathered(const Cell& cell, const NodeArray& displacements) {
  CellVector u(2 * cell.element.n_nodes);
  for (Index k = 0; k < cell.element.n_nodes; ++k)
    u.segment<2>(2 * k) = displacements.row(cell.node(k)).transpose();
  return u;
}

}  // namespace signorini

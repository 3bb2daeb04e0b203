// # The seam to finite strain
//
// Small strain is linear: the forces of a cell are \f$ Ku \f$, whatever u is. If strains are not
// small, forces, stress and stiffness all depend on u, and on a law of the material. What such a
// law says of a cell is one struct, so that assembly, stresses and support forces ask one question.

#include "signorini/fem/strain_law.hpp"

namespace signorini {

CellVector less_shift(const Cell& cell, const NodeArray& displacements) {
  CellVector u = gathered(cell, displacements);
  const Eigen::Vector2d shift(cell.body.depth.axial ? 0.0 : u(0), u(1));
  for (Eigen::Index k = 0; k < cell.element.n_nodes; ++k) u.segment<2>(2 * k) -= shift;
  return u;
}

CellAnswer answer_of(const Cell& cell, const NodeArray& displacements) {
  CellAnswer answer;
  cell.material.law->answer(cell, less_shift(cell, displacements), answer);
  return answer;
}

}  // namespace signorini

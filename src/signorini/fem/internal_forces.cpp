// # What a body answers to given displacements
//
// Each cell pulls at its nodes with \f$ K_c u_c \f$, or with what its law says where strains are
// not small. Summed over the cells, these forces balance the loads at every free component. At a
// held one they do not: what is left is the force of the support. A bar of two cells of stiffness
// 1, held at its left end and pulled with 3 at its right one, has the displacements 0, 3 and 6. Its
// internal forces are -3, 0 and 3: the support pulls with 3.

#include "signorini/core/errors.hpp"
#include "signorini/fem/assembly.hpp"
#include "signorini/fem/eigenstrain.hpp"
#include "signorini/fem/strain_law.hpp"

namespace signorini {

using Eigen::Index;

/// The sum of assemble() with all rows, held ones too, and without storing \f$K\f$. In a row that is held,
/// these forces less the loads are the force of the support. Such a row was not solved, so that it
/// need not add up to 0.
NodeArray internal_forces(const Mesh& mesh, const Element& element, const MaterialField& material,
                          const NodeArray& displacements) {
  require_argument(displacements.rows() == mesh.n_nodes(), "internal_forces: need ", mesh.n_nodes(),
                   " displacements (one per node), got ", displacements.rows());
  NodeArray forces = NodeArray::Zero(mesh.n_nodes(), 2);
  if (material.eigenstrain) forces -= eigenstrain_forces(mesh, element, material);
  visit_cells(mesh, element, material, [&](const Cell& cell) {
    const CellVector f =
        cell.material.law != nullptr
            ? answer_of(cell, displacements).force
            : CellVector(cell_stiffness(cell.element, cell.body) * gathered(cell, displacements));
    for (Index k = 0; k < cell.element.n_nodes; ++k)
      forces.row(cell.node(k)) += f.segment<2>(2 * k).transpose();
  });
  return forces;
}

}  // namespace signorini

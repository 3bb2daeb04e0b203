// # Strains without stress
//
// Warmth, swelling and shrinkage give each point a strain \f$\epsilon_0\f$ that needs no stress:
// \f$\sigma = D\,(\varepsilon - \epsilon_0)\f$. Put into the virtual work, the second term is a
// load,
//
// \f[ p = \int B^T D\,\epsilon_0\,dV, \qquad K u = p + \ldots \f]
//
// A unit square in plane strain with \f$E = 1\f$, \f$\nu = 0.3\f$ that wants to grow by 0.001 in
// all three directions gets \f$\pm 0.00125\f$ on each node in \f$x\f$ and in \f$y\f$. If supports
// hold it, nothing moves and the stress is \f$-0.0025 = -0.001\,E/(1-2\nu)\f$ in all directions.

#include "signorini/fem/eigenstrain.hpp"

namespace signorini {

using Eigen::Index;

/// In plane strain the growth across the plane is suppressed, and Poisson's effect turns it into
/// growth in the plane: 0.001 in three directions becomes 0.0013 in two. Plane stress suppresses
/// nothing.
Eigen::Vector4d strain_in_plane(const Material& material, const Eigen::Vector4d& free) {
  if (material.state != PlaneState::Strain) return free;
  const double held = material.poisson_ratio * free(3);
  return {free(0) + held, free(1) + held, free(2), 0};
}

/// Stresses are read at the strain points, where the incompatible modes of an element have had
/// their share of the eigenstrain. Load and stress must use the same numbers. If they did not, a
/// body that is free to grow would report stresses.
PointStrains eigenstrains(const Cell& cell, const StrainPoints& points, const Eigenstrain& free) {
  const Index n_rows = cell.body.D.rows();
  PointStrains strains(n_rows, points.size);
  for (int i = 0; i < points.size; ++i) {
    const Eigen::Vector2d x = position(cell, points.point[static_cast<std::size_t>(i)]);
    strains.col(i) = strain_in_plane(cell.material, free(cell.material, x)).head(n_rows);
  }
  if (cell.element.relax != nullptr) cell.element.relax(cell.body, points, strains);
  return strains;
}

NodeArray eigenstrain_forces(const Mesh& mesh, const Element& element,
                             const MaterialField& material) {
  NodeArray forces = NodeArray::Zero(mesh.n_nodes(), 2);
  if (!material.eigenstrain) return forces;
  visit_strains(mesh, element, material, [&](const Cell& cell, const StrainPoints& points) {
    const PointStrains strains = eigenstrains(cell, points, material.eigenstrain);
    for (int i = 0; i < points.size; ++i) {
      const StrainPoint& point = points.point[static_cast<std::size_t>(i)];
      const CellVector f = point.volume * (point.B.transpose() * (cell.body.D * strains.col(i)));
      for (Index k = 0; k < cell.element.n_nodes; ++k)
        forces.row(cell.node(k)) += f.segment<2>(2 * k).transpose();
    }
  });
  return forces;
}

}  // namespace signorini

#include "signorini/fem/eigenstrain.hpp"

namespace signorini {

using Eigen::Index;

Eigen::Vector4d strain_in_plane(const Material& material, const Eigen::Vector4d& free) {
  if (material.state != PlaneState::Strain) return free;
  const double held = material.poisson_ratio * free(3);
  return {free(0) + held, free(1) + held, free(2), 0};
}

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

#include "addons/effects/thermal.hpp"

namespace signorini {

using Eigen::Index;

Eigen::Vector4d thermal_strain(const Material& material, double temperature) {
  double strain = material.expansion * temperature;
  if (material.state == PlaneState::Strain) strain *= 1 + material.poisson_ratio;
  return {strain, strain, 0, strain};
}

Eigen::Vector2d position(const Cell& cell, const StrainPoint& point) {
  return cell.body.position(cell.element.shape(point.local.x(), point.local.y()).value);
}

PointStrains thermal_strains(const Cell& cell, const StrainPoints& points,
                             const Temperature& temperature) {
  const Index n_rows = cell.body.D.rows();
  PointStrains strains(n_rows, points.size);
  for (int i = 0; i < points.size; ++i) {
    const double warmer = temperature.at(position(cell, points.point[static_cast<std::size_t>(i)]));
    strains.col(i) = thermal_strain(cell.material, warmer).head(n_rows);
  }
  if (cell.element.relax != nullptr) cell.element.relax(cell.body, points, strains);
  return strains;
}

NodeArray thermal_forces(const Mesh& mesh, const Element& element, const Matter& matter) {
  NodeArray forces = NodeArray::Zero(mesh.n_nodes(), 2);
  if (!matter.temperature.warms()) return forces;
  visit_strains(mesh, element, matter, [&](const Cell& cell, const StrainPoints& points) {
    const PointStrains strains = thermal_strains(cell, points, matter.temperature);
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

#include "signorini/elasticity/stress.hpp"

#include <cmath>

#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/elasticity/assembly.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using PointStress = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::ColMajor, max_strain_points, 3>;

/// Calls visit(cell, points, stress) with the strain points of every cell and the stress at them, row by row.
template <typename Visit>
void visit_cells(const Mesh& mesh, const Element& element, const Material& material,
                 const NodeArray& displacements, Visit&& visit) {
  require(displacements.rows() == mesh.n_nodes(), "stress: need the displacements of ",
          mesh.n_nodes(), " nodes, got ", displacements.rows());
  const Eigen::Matrix3d D = elasticity_matrix(material);
  StrainPoints points;
  CellVector u(2 * element.n_nodes);
  PointStress stress;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    element.strain(arms_from_middle(cell_nodes(mesh, cell)), D, points);
    for (Index k = 0; k < element.n_nodes; ++k)
      u.segment<2>(2 * k) = displacements.row(mesh.cells(cell, k)).transpose();
    stress.resize(points.size, 3);
    for (int i = 0; i < points.size; ++i)
      stress.row(i) = (D * (points.point[static_cast<std::size_t>(i)].B * u)).transpose();
    visit(cell, points, stress);
  }
}

/// Takes values at the strain points to the nodes through the bilinear function that fits them best.
Eigen::MatrixXd extrapolation(const Element& element, const StrainPoints& points) {
  const auto monomials = [](const Eigen::Vector2d& x) {
    return Eigen::RowVector4d(1, x.x(), x.y(), x.x() * x.y());
  };
  Eigen::MatrixXd at_points(points.size, 4);
  for (int i = 0; i < points.size; ++i)
    at_points.row(i) = monomials(points.point[static_cast<std::size_t>(i)].local);
  const Eigen::Vector2d corner[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  Eigen::MatrixXd at_nodes(element.n_nodes, 4);
  for (Index k = 0; k < element.n_nodes; ++k)
    at_nodes.row(k) =
        monomials(k < 4 ? corner[k] : Eigen::Vector2d(0.5 * (corner[k - 4] + corner[(k - 3) % 4])));
  return at_nodes * pseudo_inverse(at_points);
}

}  // namespace

StressArray nodal_stress(const Mesh& mesh, const Element& element, const Material& material,
                         const NodeArray& displacements) {
  StressArray stress = StressArray::Zero(mesh.n_nodes(), 3);
  Eigen::VectorXd cells_at = Eigen::VectorXd::Zero(mesh.n_nodes());
  Eigen::MatrixXd to_nodes;
  visit_cells(mesh, element, material, displacements,
              [&](Index cell, const StrainPoints& points, const PointStress& at_points) {
                if (to_nodes.size() == 0) to_nodes = extrapolation(element, points);
                for (Index k = 0; k < element.n_nodes; ++k) {
                  stress.row(mesh.cells(cell, k)) += to_nodes.row(k) * at_points;
                  cells_at(mesh.cells(cell, k)) += 1;
                }
              });
  for (Index node = 0; node < mesh.n_nodes(); ++node)
    if (cells_at(node) > 0) stress.row(node) /= cells_at(node);
  return stress;
}

StressArray cell_stress(const Mesh& mesh, const Element& element, const Material& material,
                        const NodeArray& displacements) {
  StressArray stress = StressArray::Zero(mesh.n_cells(), 3);
  visit_cells(mesh, element, material, displacements,
              [&](Index cell, const StrainPoints& points, const PointStress& at_points) {
                double area = 0;
                for (int i = 0; i < points.size; ++i) {
                  const double share = points.point[static_cast<std::size_t>(i)].area;
                  stress.row(cell) += share * at_points.row(i);
                  area += share;
                }
                stress.row(cell) /= area;
              });
  return stress;
}

double von_mises(const Material& material, const Eigen::Vector3d& stress) {
  const double across = stress_across(material, stress);
  const double xy = stress(0) - stress(1);
  const double yz = stress(1) - across;
  const double zx = across - stress(0);
  return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3 * stress(2) * stress(2));
}

}  // namespace signorini

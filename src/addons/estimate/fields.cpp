#include "addons/estimate/fields.hpp"

#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// Adds the strains of one cell. \param u  the displacements of its nodes, of each field
template <int n_rows>
void add_strains(const Cell& cell, const StrainPoints& points, const FreeStrains& free,
                 const std::vector<CellVector>& u, ElementStrains& strains) {
  using Components = Eigen::Matrix<double, n_rows, 1>;
  StrainMatrix conforming;  // B of the displacements alone
  for (int i = 0; i < points.size; ++i) {
    const StrainPoint& point = points.point[at(i)];
    const Shape shape = cell.element.shape(point.local.x(), point.local.y());
    write_strain_matrix(jacobian(shape, cell.body.arms).gradient,
                        cell.body.hoop(shape.value, shape.value), conforming);
    strains.local.push_back(point.local);
    strains.volume.push_back(point.volume);
    for (std::size_t f = 0; f < u.size(); ++f) {
      Components elastic = fixed_rows<n_rows>(point.B) * u[f];
      Components modes = elastic - fixed_rows<n_rows>(conforming) * u[f];
      if (free.in(static_cast<Index>(f))) {
        const Components relaxed = free.relaxed(i);
        elastic -= relaxed;
        modes += free.at(cell, point).template head<n_rows>() - relaxed;
      }
      strains.elastic.insert(strains.elastic.end(), elastic.begin(), elastic.end());
      strains.modes.insert(strains.modes.end(), modes.begin(), modes.end());
    }
  }
}

}  // namespace

ElementStrains element_strains(const PrimalAndDuals& fields) {
  ElementStrains strains;
  strains.first.push_back(0);
  FreeStrains free(fields.material);
  std::vector<CellVector> u(fields.displacements.size());
  visit_strains(fields.mesh, fields.element, fields.material,
                [&](const Cell& cell, const StrainPoints& points) {
                  free.look(cell, points);
                  for (std::size_t f = 0; f < u.size(); ++f)
                    u[f] = gathered(cell, fields.displacements[f]);
                  with_rows(cell.body.D.rows(), [&](auto n_rows) {
                    add_strains<n_rows>(cell, points, free, u, strains);
                  });
                  strains.first.push_back(strains.first.back() + points.size);
                });
  return strains;
}

void check_primal_and_duals(const PrimalAndDuals& fields) {
  for (const NodeArray& u : fields.displacements)
    require_argument(u.rows() == fields.mesh.n_nodes(), "recovery: need the displacements of ",
                     fields.mesh.n_nodes(), " nodes, got ", u.rows());
}

}  // namespace signorini

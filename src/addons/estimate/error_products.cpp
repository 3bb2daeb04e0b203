#include "addons/estimate/error_products.hpp"

#include <Eigen/LU>

#include "signorini/core/index.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d;

/// One field at a strain point.
template <int n_rows>
struct Seen {
  using Components = Eigen::Matrix<double, n_rows, 1>;
  Components smooth = Components::Zero();  // the recovered stress
  Components error;                        // that less the stress of the element
  Components modes;                        // strain that is not that of the displacements

  Seen(const Cell& cell, const CellScalars& shape, const SmoothStress& stress, Index n_fields,
       Index point, Index field)
      : modes(ElementStrains::of<n_rows>(stress.strains.modes, n_fields * point + field)) {
    for (Index k = 0; k < cell.element.n_nodes; ++k)
      smooth += shape(k) * stress.value.row(stress.cells(cell.number, k))
                               .template segment<n_rows>(n_rows * field)
                               .transpose();
    error =
        smooth - fixed_rows<n_rows>(cell.body.D) *
                     ElementStrains::of<n_rows>(stress.strains.elastic, n_fields * point + field);
  }
};

}  // namespace

Eigen::MatrixXd error_products(const PrimalAndDuals& fields, const SmoothStress& stress,
                               const Eigen::VectorXd& counted) {
  check_primal_and_duals(fields);
  const Index n_fields = static_cast<Index>(fields.displacements.size());
  Eigen::MatrixXd products = Eigen::MatrixXd::Zero(fields.mesh.n_cells(), n_fields - 1);
  std::vector<Elasticity> inverse = elasticity_matrices(fields.material);
  for (Elasticity& D : inverse) D = Elasticity(D.inverse());
  const ElementStrains& strains = stress.strains;
  visit_cells(fields.mesh, fields.element, fields.material, [&](const Cell& cell) {
    const double difference = counted.size() > 0 ? counted(cell.number) : 1;
    with_rows(cell.body.D.rows(), [&](auto n_rows) {
      const auto C = fixed_rows<n_rows>(inverse[fields.material.number(cell.number)]);
      for (Index i = strains.first[at(cell.number)]; i < strains.first[at(cell.number) + 1]; ++i) {
        const Vector2d local = strains.local[at(i)];
        const CellScalars shape = cell.element.shape(local.x(), local.y()).value;
        const Seen<n_rows> u(cell, shape, stress, n_fields, i, 0);
        for (Index f = 1; f < n_fields; ++f) {
          const Seen<n_rows> z(cell, shape, stress, n_fields, i, f);
          products(cell.number, f - 1) +=
              strains.volume[at(i)] * (difference * u.error.dot(C * z.error) +
                                       u.smooth.dot(z.modes) + z.smooth.dot(u.modes));
        }
      }
    });
  });
  return products;
}

}  // namespace signorini

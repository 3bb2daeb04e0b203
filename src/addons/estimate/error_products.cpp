#include "addons/estimate/error_products.hpp"

#include <Eigen/LU>

#include "signorini/core/index.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// One field at a strain point.
template <int n_rows>
struct Seen {
  using Components = Eigen::Matrix<double, n_rows, 1>;
  Components smooth = Components::Zero();  // the recovered stress
  Components error;                        // that less the stress of the element
  Components modes;                        // strain that is not that of the displacements
};

/// A strain point of a cell.
struct Place {
  const Cell& cell;
  const StrainPoint& point;
  int number;               // of the point
  Shape shape;              // there
  StrainMatrix conforming;  // B of the displacements alone

  Place(const Cell& of, const StrainPoint& strains, int i)
      : cell(of),
        point(strains),
        number(i),
        shape(of.element.shape(strains.local.x(), strains.local.y())) {
    write_strain_matrix(jacobian(shape, cell.body.arms).gradient,
                        cell.body.hoop(shape.value, shape.value), conforming);
  }

  template <int n_rows>
  [[nodiscard]] Seen<n_rows> look(const PrimalAndDuals& fields, const SmoothStress& stress,
                                  const FreeStrains& free, Index f) const {
    using Components = typename Seen<n_rows>::Components;
    Seen<n_rows> seen;
    const CellVector u = gathered(cell, fields.displacements[at(f)]);
    Components strain = fixed_rows<n_rows>(point.B) * u;
    seen.modes = strain - fixed_rows<n_rows>(conforming) * u;
    if (free.in(f)) {
      const Components relaxed = free.relaxed(number);
      strain -= relaxed;
      seen.modes += free.at(cell, point).template head<n_rows>() - relaxed;
    }
    for (Index k = 0; k < cell.element.n_nodes; ++k)
      seen.smooth += shape.value(k) * stress.value.row(stress.cells(cell.number, k))
                                          .template segment<n_rows>(n_rows * f)
                                          .transpose();
    seen.error = seen.smooth - fixed_rows<n_rows>(cell.body.D) * strain;
    return seen;
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
  FreeStrains free(fields.material);
  visit_strains(fields.mesh, fields.element, fields.material,
                [&](const Cell& cell, const StrainPoints& points) {
                  const double difference = counted.size() > 0 ? counted(cell.number) : 1;
                  free.look(cell, points);
                  with_rows(cell.body.D.rows(), [&](auto n_rows) {
                    const auto C = fixed_rows<n_rows>(inverse[fields.material.number(cell.number)]);
                    for (int i = 0; i < points.size; ++i) {
                      const Place place(cell, points.point[at(i)], i);
                      const Seen<n_rows> u = place.look<n_rows>(fields, stress, free, 0);
                      for (Index f = 1; f < n_fields; ++f) {
                        const Seen<n_rows> z = place.look<n_rows>(fields, stress, free, f);
                        products(cell.number, f - 1) +=
                            place.point.volume * (difference * u.error.dot(C * z.error) +
                                                  u.smooth.dot(z.modes) + z.smooth.dot(u.modes));
                      }
                    }
                  });
                });
  return products;
}

}  // namespace signorini

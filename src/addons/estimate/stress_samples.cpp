#include "addons/estimate/stress_samples.hpp"

#include "signorini/core/index.hpp"

namespace signorini {
namespace {

using Eigen::Index;

Index components(const PrimalAndDuals& fields) {
  return fields.material.base.state == PlaneState::Axial ? 4 : 3;
}

StressSamples no_samples(const PrimalAndDuals& fields) {
  StressSamples samples;
  const Index n_cells = fields.mesh.n_cells();
  samples.place.resize(at(n_cells * StressSamples::most));
  samples.count.resize(at(n_cells));
  samples.value.setZero(n_cells * StressSamples::most,
                        components(fields) * static_cast<Index>(fields.displacements.size()));
  return samples;
}

/// Cells of two nodes per side: the mean of their strain points, taken at the middle.
StressSamples sampled_in_the_middle(const PrimalAndDuals& fields, const ElementStrains& strains) {
  StressSamples samples = no_samples(fields);
  const Index n_fields = static_cast<Index>(fields.displacements.size());
  visit_cells(fields.mesh, fields.element, fields.material, [&](const Cell& cell) {
    const Index first = strains.first[at(cell.number)], end = strains.first[at(cell.number) + 1];
    const Index row = cell.number * StressSamples::most;
    const bool triangle = cell.element.corners() == 3;
    const double middle = triangle ? 1.0 / 3 : 0;
    samples.place[at(row)] = cell.body.position(cell.element.shape(middle, middle).value);
    samples.count[at(cell.number)] = 1;
    with_rows(cell.body.D.rows(), [&](auto n_rows) {
      for (Index f = 0; f < n_fields; ++f) {
        Eigen::Matrix<double, n_rows, 1> sum = Eigen::Matrix<double, n_rows, 1>::Zero();
        for (Index i = first; i < end; ++i)
          sum += ElementStrains::of<n_rows>(strains.elastic, n_fields * i + f);
        samples.value.row(row).template segment<n_rows>(n_rows * f) =
            (fixed_rows<n_rows>(cell.body.D) * sum / (end - first)).transpose();
      }
    });
  });
  return samples;
}

/// Cells of three nodes per side: the 2 x 2 points of the square, the 3 of the triangle.
StressSamples sampled_at_points(const PrimalAndDuals& fields) {
  StressSamples samples = no_samples(fields);
  const Index rows = components(fields);
  StrainPoints points;
  FreeStrains free(fields.material);
  visit_cells(fields.mesh, fields.element, fields.material, [&](const Cell& cell) {
    sample_strain(cell.element.shape,
                  cell.element.corners() == 3 ? gauss_triangle(3) : gauss_square(2), cell.body,
                  points);
    free.look(cell, points);
    samples.count[at(cell.number)] = points.size;
    for (std::size_t f = 0; f < fields.displacements.size(); ++f) {
      const CellVector u = gathered(cell, fields.displacements[f]);
      for (int i = 0; i < points.size; ++i) {
        const StrainPoint& point = points.point[at(i)];
        const Index row = cell.number * StressSamples::most + i;
        samples.place[at(row)] = position(cell, point);
        Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 4, 1> strain = point.B * u;
        if (free.in(static_cast<Index>(f))) strain -= free.relaxed(i);
        samples.value.row(row).segment(rows * static_cast<Index>(f), rows) =
            (cell.body.D * strain).transpose();
      }
    }
  });
  return samples;
}

}  // namespace

StressSamples sampled(const PrimalAndDuals& fields, const ElementStrains& strains) {
  return fields.mesh.order() == MeshOrder::Linear ? sampled_in_the_middle(fields, strains)
                                                  : sampled_at_points(fields);
}

}  // namespace signorini

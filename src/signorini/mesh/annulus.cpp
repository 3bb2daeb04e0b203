#include "signorini/mesh/annulus.hpp"

#include <cmath>

#include "signorini/core/errors.hpp"

namespace signorini {

using Eigen::Index;

Mesh make_annulus(const AnnulusSpec& spec) {
  require(spec.inner_radius > 0 && spec.outer_radius > spec.inner_radius &&
              std::isfinite(spec.outer_radius) && spec.centre.allFinite(),
          "make_annulus '", spec.name, "': need 0 < inner radius < outer radius, got ",
          spec.inner_radius, " and ", spec.outer_radius);
  require(spec.cells_angle > 0 && spec.cells_radius > 0, "make_annulus '", spec.name,
          "': need at least one cell in each direction, got ", spec.cells_angle, " x ",
          spec.cells_radius);
  const Eigen::VectorXd directions = ray_directions(spec.rays, spec.cells_angle, spec.sector);
  NodeArray inner(directions.size(), 2);
  NodeArray outer(directions.size(), 2);
  for (Index i = 0; i < directions.size(); ++i) {
    const Eigen::RowVector2d direction = unit_vector(directions(i));
    inner.row(i) = spec.centre.transpose() + spec.inner_radius * direction;
    outer.row(i) = spec.centre.transpose() + spec.outer_radius * direction;
  }
  Mesh mesh =
      make_ring_of_rays(spec.name, inner, outer, graded_steps(spec.cells_radius, spec.grading),
                        spec.sector, spec.order);
  rename_boundary(mesh, "end", spec.sector == Sector::Quarter ? "symmetry_y" : "symmetry");
  rename_boundary(mesh, "start", "symmetry");
  return mesh;
}

double similar_cells(double outer_over_inner, Index cells_radius) {
  require(outer_over_inner > 1 && std::isfinite(outer_over_inner) && cells_radius > 0,
          "similar_cells: need a ratio of radii above 1 and at least one cell, got ",
          outer_over_inner, " and ", cells_radius);
  const double n = static_cast<double>(cells_radius);
  return std::pow(outer_over_inner, (n - 1) / n);
}

}  // namespace signorini

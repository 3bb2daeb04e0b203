#include "meshes/ring.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "meshes/lattice.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {

using Eigen::Index;

double opening(Sector sector) {
  return sector == Sector::Quarter ? pi / 2 : sector == Sector::Half ? pi : 2 * pi;
}

Eigen::VectorXd ray_directions(const Eigen::VectorXd& rays, Index cells, Sector sector) {
  const double last = opening(sector);
  require_argument(cells > 0 && (rays.size() == 0 || rays.size() == cells + 1),
                   "rays: need at least one cell along the angle and one ray more than cells, got ",
                   cells, " cells and ", rays.size(), " rays");
  const Eigen::VectorXd even = Eigen::VectorXd::LinSpaced(cells + 1, 0, last);
  const Eigen::VectorXd& given = rays.size() == 0 ? even : rays;
  const Eigen::VectorXd step = given.tail(cells) - given.head(cells);
  require_argument(step.minCoeff() > 0 && step.maxCoeff() < pi && std::abs(given(0)) < 1e-12 &&
                       std::abs(given(cells) - last) < 1e-12,
                   "rays: directions must increase from 0 to ", last,
                   " in steps below half a turn; they run from ", given(0), " to ", given(cells),
                   " in steps of ", step.minCoeff(), " to ", step.maxCoeff());
  Eigen::VectorXd directions(2 * cells + 1);
  for (Index i = 0; i <= 2 * cells; ++i) directions(i) = at_half(given, i);
  return directions;
}

Eigen::VectorXd rays_by_quadrant(const std::vector<Index>& cells) {
  require_argument((cells.size() == 1 || cells.size() == 2 || cells.size() == 4) &&
                       *std::min_element(cells.begin(), cells.end()) > 0,
                   "rays_by_quadrant: need at least one cell in each of 1, 2 or 4 quadrants");
  Eigen::VectorXd rays(std::accumulate(cells.begin(), cells.end(), Index{1}));
  Index ray = 0;
  for (std::size_t quadrant = 0; quadrant < cells.size(); ++quadrant)
    for (Index k = 0; k < cells[quadrant]; ++k)
      rays(ray++) = pi / 2 *
                    (static_cast<double>(quadrant) +
                     static_cast<double>(k) / static_cast<double>(cells[quadrant]));
  rays(ray) = pi / 2 * static_cast<double>(cells.size());
  return rays;
}

Eigen::RowVector2d unit_vector(double angle) {
  const double none = 8 * epsilon;
  const auto clean = [none](double value) { return std::abs(value) < none ? 0 : value; };
  return {clean(std::cos(angle)), clean(std::sin(angle))};
}

Mesh make_ring_of_rays(const std::string& name, const NodeArray& inner, const NodeArray& outer,
                       const Eigen::VectorXd& steps, Sector sector, MeshOrder order) {
  const std::string end = sector == Sector::Quarter ? "symmetry_y" : "symmetry";
  const Lattice lattice{steps.size() - 1,
                        inner.rows() / 2,
                        order,
                        sector == Sector::Full,
                        {"symmetry", "outer", end, "inner"}};
  return make_lattice(name, lattice, [&](Index i, Index j) -> Eigen::RowVector2d {
    const double z = at_half(steps, i);
    return (1 - z) * inner.row(j) + z * outer.row(j);
  });
}

Mesh make_annulus(const AnnulusSpec& spec) {
  require_argument(spec.inner_radius > 0 && spec.outer_radius > spec.inner_radius &&
                       std::isfinite(spec.outer_radius) && spec.centre.allFinite(),
                   "make_annulus '", spec.name, "': need 0 < inner radius < outer radius, got ",
                   spec.inner_radius, " and ", spec.outer_radius);
  require_argument(spec.cells_angle > 0 && spec.cells_radius > 0, "make_annulus '", spec.name,
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
  return make_ring_of_rays(spec.name, inner, outer, graded_steps(spec.cells_radius, spec.grading),
                           spec.sector, spec.order);
}

double similar_cells(double outer_over_inner, Index cells_radius) {
  require_argument(outer_over_inner > 1 && std::isfinite(outer_over_inner) && cells_radius > 0,
                   "similar_cells: need a ratio of radii above 1 and at least one cell, got ",
                   outer_over_inner, " and ", cells_radius);
  const double n = static_cast<double>(cells_radius);
  return std::pow(outer_over_inner, (n - 1) / n);
}

}  // namespace signorini

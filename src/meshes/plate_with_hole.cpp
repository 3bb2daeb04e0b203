#include "meshes/plate_with_hole.hpp"

#include <algorithm>
#include <cmath>

#include "meshes/reshape.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using std::string_literals::operator""s;

void check(const PlateWithHoleSpec& spec) {
  require_argument(spec.hole_radius > 0 && spec.size.allFinite() && spec.centre.allFinite() &&
                       spec.size.minCoeff() > 2 * spec.hole_radius,
                   "make_plate_with_hole '", spec.name, "': the hole of radius ", spec.hole_radius,
                   " must fit into the plate of ", spec.size.x(), " x ", spec.size.y());
  require_argument(spec.cells_angle > 0 && spec.cells_radius > 0, "make_plate_with_hole '",
                   spec.name, "': need at least one cell in each direction, got ", spec.cells_angle,
                   " x ", spec.cells_radius);
}

/// Where a ray from the middle of a rectangle meets its sides.
Eigen::RowVector2d on_rectangle(const Eigen::RowVector2d& direction,
                                const Eigen::RowVector2d& half) {
  const double x = std::abs(direction.x()) * half.y();
  const double y = std::abs(direction.y()) * half.x();
  // The component across the side that is met is exact.
  if (x >= y)
    return {std::copysign(half.x(), direction.x()),
            direction.y() * half.x() / std::abs(direction.x())};
  return {direction.x() * half.y() / std::abs(direction.y()),
          std::copysign(half.y(), direction.y())};
}

/// Moves the outer end of the nearest ray into every corner that the sector has.
void meet_corners(const PlateWithHoleSpec& spec, const Eigen::VectorXd& directions,
                  const Eigen::RowVector2d& half, NodeArray& outer) {
  const double corner = std::atan2(half.y(), half.x());
  Index before = -1;
  for (const double angle : {corner, pi - corner, pi + corner, 2 * pi - corner}) {
    if (angle > opening(spec.sector)) break;
    Index nearest = 0;
    for (Index i = 0; i < directions.size(); i += 2) {
      const double better = std::abs(directions(nearest) - angle) - std::abs(directions(i) - angle);
      if (better > 1e-9) nearest = i;  // not by rounding
    }
    const bool at_end = nearest == 0 || nearest == directions.size() - 1;
    require_argument(nearest != before && !at_end, "make_plate_with_hole '", spec.name,
                     "': ", spec.cells_angle,
                     " cells along the hole leave no ray for the corner at ", angle * 180 / pi,
                     " degrees; give more cells or other rays");
    outer.row(nearest) << std::copysign(half.x(), std::cos(angle)),
        std::copysign(half.y(), std::sin(angle));
    before = nearest;
  }
}

/// Names the outer sides after the side of the rectangle that they lie on.
void name_sides(const Eigen::RowVector2d& half, const Eigen::RowVector2d& centre, bool closed,
                Mesh& mesh) {
  const auto name_of = [&](const CellSide& side) {
    const std::vector<Index> nodes = mesh.side_nodes(side);
    const Eigen::RowVector2d middle =
        (0.5 * (mesh.nodes.row(nodes.front()) + mesh.nodes.row(nodes.back())) - centre)
            .cwiseQuotient(half);
    const bool upright = std::abs(middle.x()) > std::abs(middle.y());
    return upright ? (middle.x() > 0 ? "right" : "left") : (middle.y() > 0 ? "top" : "bottom");
  };
  std::vector<CellSide> outer = mesh.boundaries.at("outer");
  mesh.boundaries.erase("outer");
  // Once round, `right` would begin in its middle.
  if (closed)
    std::rotate(outer.begin(),
                std::find_if(outer.begin(), outer.end(),
                             [&](const CellSide& side) { return name_of(side) != "right"s; }),
                outer.end());
  for (const CellSide& side : outer) mesh.boundaries[name_of(side)].push_back(side);
}

}  // namespace

Mesh make_plate_with_hole(const PlateWithHoleSpec& spec) {
  check(spec);
  const Eigen::VectorXd directions = ray_directions(spec.rays, spec.cells_angle, spec.sector);
  const Eigen::RowVector2d half = 0.5 * spec.size.transpose();
  const Eigen::RowVector2d centre = spec.centre.transpose();
  NodeArray inner(directions.size(), 2);
  NodeArray outer(directions.size(), 2);
  for (Index i = 0; i < directions.size(); ++i) {
    const Eigen::RowVector2d direction = unit_vector(directions(i));
    inner.row(i) = spec.hole_radius * direction;
    outer.row(i) = on_rectangle(direction, half);
  }
  meet_corners(spec, directions, half, outer);
  for (Index i = 1; i < directions.size(); i += 2)  // the outer sides are straight
    outer.row(i) = 0.5 * (outer.row(i - 1) + outer.row(i + 1));
  inner.rowwise() += centre;
  outer.rowwise() += centre;

  Mesh mesh =
      make_ring_of_rays(spec.name, inner, outer, graded_steps(spec.cells_radius, spec.grading),
                        spec.sector, spec.order);
  name_sides(half, centre, spec.sector == Sector::Full, mesh);
  return renamed(mesh, "inner", "hole");
}

}  // namespace signorini

#include <cmath>

#include "meshes/block.hpp"
#include "meshes/disc.hpp"
#include "meshes/quarter_grid.hpp"
#include "meshes/reshape.hpp"
#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d;

void check(const PressedDiscSpec& spec) {
  require_argument(spec.radius > 0 && std::isfinite(spec.radius) && spec.pole.allFinite(),
                   "make_pressed_disc '", spec.name, "': radius must be positive, got ",
                   spec.radius);
  require_argument(spec.core.minCoeff() > 0 && spec.core.maxCoeff() < spec.radius / 2,
                   "make_pressed_disc '", spec.name,
                   "': width and depth of the core must be above 0 and below half the radius, ",
                   spec.radius / 2, ", got ", spec.core.x(), " and ", spec.core.y());
  require_argument(spec.core_columns > 0 && spec.core_rows > 0 && spec.layers > 0,
                   "make_pressed_disc '", spec.name,
                   "': core_columns, core_rows and layers must be at least 1, got ",
                   spec.core_columns, ", ", spec.core_rows, " and ", spec.layers);
  require_argument(spec.layer_grading > 0 && std::isfinite(spec.layer_grading),
                   "make_pressed_disc '", spec.name, "': layer_grading must be positive, got ",
                   spec.layer_grading);
}

/// The map of the upper half plane to the disc of radius `radius` that touches y = 0 at the origin.
Vector2d moebius(const Vector2d& w, double radius) {
  const Vector2d v = w / (2 * radius);
  const double stretch = (1 + v.y()) * (1 + v.y()) + v.x() * v.x();
  return Vector2d(w.x(), w.y() * (1 + v.y()) + w.x() * v.x()) / stretch;
}

/// Where the core has its nodes before the map: even ones in the disc, as seen by `before`.
template <typename Before>
Eigen::VectorXd core_places(double length, Index cells, Before before) {
  Eigen::VectorXd places = length * graded_steps(2 * cells, 1);
  for (double& place : places) place = before(place);
  return places;
}

}  // namespace

Mesh part_of_disc(const Mesh& quarter, double level, DiscPart part) {
  if (part == DiscPart::LowerRight) return quarter;
  const Mesh right =
      joined(quarter, "middle", mirrored(quarter, MirrorLine::Level, level), "middle");
  if (part == DiscPart::Right) return right;
  return joined(right, "axis", mirrored(right, MirrorLine::Upright), "axis");
}

Mesh make_pressed_disc(const PressedDiscSpec& spec) {
  check(spec);
  const double radius = spec.radius;
  QuarterGrid grid;
  grid.name = spec.name;
  grid.columns = core_places(spec.core.x(), spec.core_columns, [radius](double x) {
    return 2 * x / (1 + std::sqrt(1 - x / radius * (x / radius)));
  });
  grid.rows = core_places(spec.core.y(), spec.core_rows,
                          [radius](double y) { return y / (1 - y / (2 * radius)); });
  const double width = grid.columns(2 * spec.core_columns);
  const double depth = grid.rows(2 * spec.core_rows);
  grid.columns /= width;
  grid.rows /= depth;
  grid.width = growing_layers(width, 2 * radius, spec.layers, spec.layer_grading);
  grid.depth = growing_layers(depth, 2 * radius, spec.layers, spec.layer_grading);
  const Eigen::ArrayXd outwards = graded_steps(spec.layers, spec.layer_grading);
  grid.roundness = 1 - (1 - outwards).square();
  grid.order = spec.order;

  Mesh quarter = mirrored(make_quarter_grid(grid), MirrorLine::Level);
  quarter = mapped(quarter, [radius](const Vector2d& w) { return moebius(w, radius); });
  quarter = renamed(renamed(quarter, "surface", "rim"), "base", "middle");
  quarter = renamed(quarter, "side", "middle");
  for (const Index node : boundary_nodes(quarter, "middle")) quarter.nodes(node, 1) = radius;
  return moved(part_of_disc(quarter, radius, spec.part), spec.pole);
}

}  // namespace signorini

#include "meshes/half_space.hpp"

#include <algorithm>
#include <cmath>

#include "meshes/lattice.hpp"
#include "meshes/quarter_grid.hpp"
#include "meshes/reshape.hpp"
#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

using Eigen::Index;

void check(const HalfSpaceSpec& spec) {
  require_argument(spec.core.minCoeff() > 0, "make_half_space '", spec.name,
                   "': width and depth of the core must be positive, got ", spec.core.x(), " and ",
                   spec.core.y());
  require_argument(spec.width > spec.core.x() && std::isfinite(spec.width), "make_half_space '",
                   spec.name, "': width must be above that of the core, ", spec.core.x(), ", got ",
                   spec.width);
  require_argument(spec.depth > spec.core.y() && std::isfinite(spec.depth), "make_half_space '",
                   spec.name, "': depth must be above that of the core, ", spec.core.y(), ", got ",
                   spec.depth);
  require_argument(spec.core_columns > 0 && spec.core_rows > 0 && spec.layers > 0,
                   "make_half_space '", spec.name,
                   "': core_columns, core_rows and layers must be at least 1, got ",
                   spec.core_columns, ", ", spec.core_rows, " and ", spec.layers);
  require_argument(spec.layer_grading > 0 && std::isfinite(spec.layer_grading), "make_half_space '",
                   spec.name, "': layer_grading must be positive, got ", spec.layer_grading);
}

void check(const EdgeBlockSpec& spec) {
  require_argument(spec.edge > 0 && spec.width > spec.edge && std::isfinite(spec.width),
                   "make_edge_block '", spec.name, "': need 0 < edge < width, got ", spec.edge,
                   " and ", spec.width);
  require_argument(spec.depth > 0 && std::isfinite(spec.depth), "make_edge_block '", spec.name,
                   "': depth must be positive, got ", spec.depth);
  require_argument(
      spec.cells_under > 0 && spec.cells_beside > 1 && spec.cells_deep > 1, "make_edge_block '",
      spec.name, "': cells_under must be at least 1, cells_beside and cells_deep at least 2, got ",
      spec.cells_under, ", ", spec.cells_beside, " and ", spec.cells_deep);
  for (const double grading :
       {spec.grading_under, spec.grading_beside.value_or(1), spec.grading_deep.value_or(1)})
    require_argument(grading > 0 && std::isfinite(grading), "make_edge_block '", spec.name,
                     "': gradings must be positive, got ", grading);
}

}  // namespace

Mesh make_half_space(const HalfSpaceSpec& spec) {
  check(spec);
  QuarterGrid grid;
  grid.name = spec.name;
  grid.columns = graded_steps(2 * spec.core_columns, 1);
  grid.rows = graded_steps(2 * spec.core_rows, 1);
  grid.width = growing_layers(spec.core.x(), spec.width, spec.layers, spec.layer_grading);
  grid.depth = growing_layers(spec.core.y(), spec.depth, spec.layers, spec.layer_grading);
  // Round half way: rays from the corner of the core then meet layers at more open angles. Where
  // the layers hardly grow, rounding them would fold cells at the corner.
  const double growth = std::log(std::min(spec.width / spec.core.x(), spec.depth / spec.core.y()));
  const Eigen::ArrayXd outwards = graded_steps(spec.layers, spec.layer_grading);
  grid.roundness = std::min(1.0, growth / 2) * 4 * outwards * (1 - outwards);
  grid.order = spec.order;
  return make_quarter_grid(grid);
}

Index EdgeBlockSpec::n_nodes() const {
  return Lattice{cells_under + cells_beside, cells_deep, order}.n_nodes();
}

Eigen::VectorXd EdgeBlockSpec::under() const {
  check(*this);
  return stretched(0, {{edge, cells_under, 1 / grading_under}});
}

Mesh make_edge_block(const EdgeBlockSpec& spec) {
  check(spec);
  const Eigen::VectorXd under = spec.under();
  const double cell = spec.edge - under(spec.cells_under - 1);
  const auto grading = [cell](const std::optional<double>& given, double length, Index cells) {
    return given ? *given : grading_from(length, cells, cell);
  };
  const double beside = grading(spec.grading_beside, spec.width - spec.edge, spec.cells_beside);
  const double deep = grading(spec.grading_deep, spec.depth, spec.cells_deep);
  const Eigen::VectorXd x = stretched(0, {{spec.edge, spec.cells_under, 1 / spec.grading_under},
                                          {spec.width, spec.cells_beside, beside}});
  const Eigen::VectorXd y = stretched(-spec.depth, {{0, spec.cells_deep, 1 / deep}});
  Mesh mesh = make_graded_block(spec.name, x, y, spec.order);
  const std::vector<CellSide>& top = boundary(mesh, "top");
  mesh.boundaries["loaded"].assign(top.begin() + spec.cells_beside, top.end());
  mesh = renamed(renamed(mesh, "top", "surface"), "bottom", "base");
  return renamed(renamed(mesh, "right", "side"), "left", "axis");
}

}  // namespace signorini

#include "meshes/disc.hpp"

#include <cmath>

#include "meshes/block.hpp"
#include "meshes/quarter_grid.hpp"
#include "meshes/reshape.hpp"
#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

void check(const DiscSpec& spec) {
  require_argument(spec.radius > 0 && std::isfinite(spec.radius) && spec.centre.allFinite(),
                   "make_disc '", spec.name, "': radius must be positive, got ", spec.radius);
  require_argument(spec.core > 0 && spec.core < 1, "make_disc '", spec.name,
                   "': core must be above 0 and below 1, got ", spec.core);
  require_argument(spec.core_roundness >= 0 && spec.core_roundness < 1, "make_disc '", spec.name,
                   "': core_roundness must be at least 0 and below 1, got ", spec.core_roundness);
  // Else the diagonals of the layers, which become rounder outwards, would run inwards at the rim.
  require_argument(2 * spec.core < 1 + spec.core_roundness, "make_disc '", spec.name,
                   "': a core of ", spec.core, " needs a core_roundness above ", 2 * spec.core - 1,
                   ", got ", spec.core_roundness);
  require_argument(spec.core_cells > 0 && spec.layers > 0, "make_disc '", spec.name,
                   "': core_cells and layers must be at least 1, got ", spec.core_cells, " and ",
                   spec.layers);
  require_argument(spec.layer_grading > 0 && std::isfinite(spec.layer_grading), "make_disc '",
                   spec.name, "': layer_grading must be positive, got ", spec.layer_grading);
}

}  // namespace

Mesh make_disc(const DiscSpec& spec) {
  check(spec);
  QuarterGrid grid;
  grid.name = spec.name;
  grid.columns = graded_steps(2 * spec.core_cells, 1);
  grid.rows = grid.columns;
  const Eigen::VectorXd outwards = graded_steps(spec.layers, spec.layer_grading);
  grid.width = spec.radius * (spec.core + (1 - spec.core) * outwards.array());
  grid.width(spec.layers) = spec.radius;
  grid.depth = grid.width;
  grid.roundness = spec.core_roundness + (1 - spec.core_roundness) * outwards.array();
  grid.roundness(spec.layers) = 1;
  grid.order = spec.order;
  Mesh quarter = renamed(make_quarter_grid(grid), "surface", "middle");
  quarter = renamed(renamed(quarter, "base", "rim"), "side", "rim");
  return moved(part_of_disc(quarter, 0, spec.part), spec.centre);
}

}  // namespace signorini

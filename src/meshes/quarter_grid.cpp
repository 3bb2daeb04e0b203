#include "meshes/quarter_grid.hpp"

#include <cmath>

#include "meshes/block.hpp"
#include "meshes/lattice.hpp"
#include "meshes/reshape.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::RowVector2d;

/// Image of (p, q) of the unit square on the line around a layer, the more an ellipse the rounder.
RowVector2d placed(const QuarterGrid& grid, Index layer, double p, double q) {
  const double half = 0.5 * grid.roundness(layer);
  return {grid.width(layer) * (p * std::sqrt(1 - half * q * q)),
          grid.depth(layer) * (q * std::sqrt(1 - half * p * p))};
}

Mesh make_core(const QuarterGrid& grid) {
  const Index rows = grid.rows.size() / 2;
  const Lattice lattice{
      grid.columns.size() / 2, rows, grid.order, false, {"seam", "seam", "surface", "axis"}};
  return make_lattice(grid.name, lattice, [&](Index i, Index j) {
    return placed(grid, 0, grid.columns(i), -grid.rows(2 * rows - j));
  });
}

Mesh make_layers(const QuarterGrid& grid) {
  const Index columns = grid.columns.size() / 2;
  const Index rows = grid.rows.size() / 2;
  // Rays run outwards from the core: along its bottom first, then up its side.
  const auto corner = [&](Index layer, Index j) -> RowVector2d {
    const bool below = j <= 2 * columns;
    const double p = below ? grid.columns(j) : 1;
    const double q = below ? -1 : -grid.rows(2 * (columns + rows) - j);
    return placed(grid, layer, p, q);
  };
  const Lattice lattice{grid.width.size() - 1,
                        columns + rows,
                        grid.order,
                        false,
                        {"axis", "base", "surface", "seam"}};
  Mesh mesh =
      make_lattice(grid.name, lattice, [&](Index i, Index j) -> RowVector2d {  // straight rays
        if (i % 2 == 0) return corner(i / 2, j);
        return 0.5 * (corner(i / 2, j) + corner(i / 2 + 1, j));
      });
  std::vector<CellSide>& base = mesh.boundaries["base"];
  mesh.boundaries["side"].assign(base.begin() + columns, base.end());
  base.erase(base.begin() + columns, base.end());
  return mesh;
}

}  // namespace

Mesh make_quarter_grid(const QuarterGrid& grid) {
  return joined(make_core(grid), "seam", make_layers(grid), "seam");
}

Eigen::VectorXd growing_layers(double core, double far, Index layers, double grading) {
  Eigen::VectorXd half_axes =
      core * (std::log(far / core) * graded_steps(layers, grading).array()).exp();
  half_axes(0) = core;
  half_axes(layers) = far;
  return half_axes;
}

}  // namespace signorini

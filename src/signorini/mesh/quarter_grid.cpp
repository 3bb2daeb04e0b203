#include "signorini/mesh/quarter_grid.hpp"

#include <cmath>

#include "signorini/mesh/block.hpp"
#include "signorini/mesh/lattice.hpp"
#include "signorini/mesh/reshape.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::RowVector2d;

/// Image of (p, q) of the unit square, the more a disc the rounder.
RowVector2d rounded(double p, double q, double roundness) {
  return {p * std::sqrt(1 - 0.5 * roundness * q * q), q * std::sqrt(1 - 0.5 * roundness * p * p)};
}

Mesh make_core(const QuarterGrid& grid) {
  const Index rows = grid.rows.size() / 2;
  Mesh core = make_lattice(grid.name, {grid.columns.size() / 2, rows, grid.order},
                           [&](Index i, Index j) -> RowVector2d {
                             const double p = grid.columns(i);
                             const double q = -grid.rows(2 * rows - j);
                             return rounded(p, q, grid.roundness(0))
                                 .cwiseProduct(RowVector2d(grid.width(0), grid.depth(0)));
                           });
  core = renamed(core, "bottom", "seam");
  core = renamed(core, "right", "seam");
  core = renamed(core, "top", "surface");
  return renamed(core, "left", "axis");
}

Mesh make_layers(const QuarterGrid& grid) {
  const Index columns = grid.columns.size() / 2;
  const Index rows = grid.rows.size() / 2;
  // Rays run outwards from the core: along its bottom first, then up its side.
  const auto corner = [&](Index layer, Index j) -> RowVector2d {
    const bool below = j <= 2 * columns;
    const double p = below ? grid.columns(j) : 1;
    const double q = below ? -1 : -grid.rows(2 * (columns + rows) - j);
    return rounded(p, q, grid.roundness(layer))
        .cwiseProduct(RowVector2d(grid.width(layer), grid.depth(layer)));
  };
  Mesh mesh = make_lattice(grid.name, {grid.width.size() - 1, columns + rows, grid.order},
                           [&](Index i, Index j) -> RowVector2d {  // straight along the rays
                             if (i % 2 == 0) return corner(i / 2, j);
                             return 0.5 * (corner(i / 2, j) + corner(i / 2 + 1, j));
                           });
  const std::vector<CellSide> outer = boundary(mesh, "right");
  mesh.boundaries.erase("right");
  mesh.boundaries["base"].assign(outer.begin(), outer.begin() + columns);
  mesh.boundaries["side"].assign(outer.begin() + columns, outer.end());
  mesh = renamed(mesh, "bottom", "axis");
  mesh = renamed(mesh, "top", "surface");
  return renamed(mesh, "left", "seam");
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

Index quarter_grid_nodes(Index columns, Index rows, Index layers, MeshOrder order) {
  const Index corners = (columns + 1) * (rows + 1) + (columns + rows + 1) * layers;
  const Index cells = columns * rows + (columns + rows) * layers;
  // Euler: corners - sides + cells = 1.
  return order == MeshOrder::Linear ? corners : corners + (corners + cells - 1);
}

}  // namespace signorini

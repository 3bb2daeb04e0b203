// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The pattern behind every generator: cells in rows and columns, bent into place.
///
/// Programs that mesh any shape exist, and the library reads their files. Tests and closed forms
/// need meshes of known structure: nodes in known places, the same on every machine.
#pragma once
#include <Eigen/Core>
#include <array>
#include <functional>
#include <string>

#include "signorini/fem/mesh.hpp"

namespace signorini {

/// Rows and columns of cells and how they hang together.
struct Lattice {
  Eigen::Index cells_x = 1;             ///< cells in a row, at least 1
  Eigen::Index cells_y = 1;             ///< rows, at least 1
  MeshOrder order = MeshOrder::Linear;  ///< 4 or 8 nodes per cell
  bool closed = false;                  ///< the last row meets the first, as around a hole
  /// Names of the boundaries below the first row, at the end of the rows, above the last one and where rows begin.
  std::array<std::string, 4> sides = {"bottom", "right", "top", "left"};

  /// \return number of nodes of the mesh
  [[nodiscard]] Eigen::Index n_nodes() const { return row_start(2 * cells_y + (closed ? 0 : 1)); }
  /// Whether there is a node; the middles of cells have none.
  /// \param i  half steps along the row, 0 to `2 cells_x`; even ones are corners
  /// \param j  half steps across the rows, 0 to `2 cells_y`
  /// \return true for corners and, in quadratic cells, midpoints of sides
  [[nodiscard]] bool has(Eigen::Index i, Eigen::Index j) const;
  /// \param i  as in has()
  /// \param j  as in has(); there must be a node at (i, j)
  /// \return its number: row by row, along the row first
  [[nodiscard]] Eigen::Index node(Eigen::Index i, Eigen::Index j) const;

 private:
  /// \return number of nodes in the rows of half steps below j
  [[nodiscard]] Eigen::Index row_start(Eigen::Index j) const;
};

/// Makes the cells of a lattice, numbered along the row first.
///
/// Boundaries `bottom` (first row, to the right), `right` (upwards), `top` (last row, to the left)
/// and `left` (downwards), under the names in `sides`, run counter-clockwise if the positions do not mirror
/// the lattice; a closed lattice has no `bottom` and no `top`. Those of one name follow one another in the order
/// top, left, bottom, right.
/// \param name      what messages call the mesh
/// \param lattice   how many cells
/// \param position  where the node at half steps (i, j) goes [length]
/// \return a mesh; not checked, see check_mesh()
[[nodiscard]] Mesh make_lattice(
    const std::string& name, const Lattice& lattice,
    const std::function<Eigen::RowVector2d(Eigen::Index i, Eigen::Index j)>& position);

/// Position at a half step.
/// \param steps  positions at whole steps
/// \param i      half steps from the first, 0 to `2 (size - 1)`
/// \return a given position, or the mean of two neighbours
[[nodiscard]] inline double at_half(const Eigen::VectorXd& steps, Eigen::Index i) {
  return i % 2 == 0 ? steps(i / 2) : 0.5 * (steps(i / 2) + steps(i / 2 + 1));
}

}  // namespace signorini

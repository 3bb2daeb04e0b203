// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Smooth stresses from those of the elements: what they differ by measures what a mesh is too coarse for.
#pragma once
#include <Eigen/Core>

#include "addons/estimate/fields.hpp"

namespace signorini {

/// Recovered stresses. A node that several layers share has a number for each of them, and a stress for each.
struct SmoothStress {
  CellArray cells;  ///< as Mesh::cells, with these numbers
  /// A row per number: the components of the first field, as many as its D has rows, then of the second, ...
  /// [force/length^2]
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> value;
  ElementStrains strains;  ///< what was recovered from
};

/// Recovers stresses node by node from the cells around it, never from another layer [\ref ZienkiewiczZhu1992].
///
/// Stresses of cells are best inside: of cells of two nodes per side their mean, taken at the middle; of those of
/// three nodes the values at the 2 x 2 points of the square, at the 3 of the triangle. A polynomial through
/// those of all cells around a corner, linear or quadratic, is fitted by least squares; the node gets what it says. Nodes
/// of the edge of a layer and midpoints of sides get the mean of what the polynomials of the corners of their cells
/// say, as far as these lie inside; where none does, as in a strip of one row of cells, the mean of the cells there.
/// \param fields  one or more
/// \return smooth stresses; exact where stresses are linear, or quadratic
/// \throws std::invalid_argument unless there is one displacement per node
/// \throws ProblemError as check_material()
[[nodiscard]] SmoothStress recovered(const PrimalAndDuals& fields);

}  // namespace signorini

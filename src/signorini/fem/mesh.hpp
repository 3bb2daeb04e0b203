/// \file
/// A mesh of triangles and quadrilaterals with named boundaries, and the checks that come before any computation.
///
/// Two conventions carry everything that follows. Cells run anticlockwise, and so do their sides:
/// side \f$s\f$ goes from corner \f$s\f$ to corner \f$s+1\f$. Whoever walks along a side has the
/// body on the left, and the normal \f$(t_y, -t_x)\f$ of the tangent \f$t\f$ points out of it. A
/// boundary is a list of such sides, not of nodes, because a node at a corner belongs to two
/// boundaries with two normals.
///
/// A mesh is plain data, which readers of files, generators and users fill. It may be wrong in many
/// ways, so check_mesh() looks at it once, before any integral.
#pragma once
#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "signorini/core/alignment.hpp"

namespace signorini {

/// Positions or vectors of nodes, one row each.
using NodeArray = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;
/// Node numbers of cells, one row each; see Mesh::cells.
using CellArray = Eigen::Matrix<Eigen::Index, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Positions as seen from the middle of their box: \f$ ((x - low) - (high - x))/2 \f$. Far from the origin they are
/// as exact as differences of the positions, and those of a mirror image are mirror images, to the last bit.
/// \param positions  `n x 2` [length]
/// \return `n x 2` arms [length]
template <typename Positions>
[[nodiscard]] Positions arms_from_middle(const Positions& positions) {
  Positions arms = positions;
  for (int axis = 0; axis < 2; ++axis) {
    const double low = positions.col(axis).minCoeff();
    const double high = positions.col(axis).maxCoeff();
    for (Eigen::Index k = 0; k < positions.rows(); ++k)
      arms(k, axis) = ((positions(k, axis) - low) - (high - positions(k, axis))) / 2;
  }
  return arms;
}

/// Nodes per cell side.
enum class MeshOrder {
  Linear,    ///< 2: cells of 3 or 4 nodes
  Quadratic  ///< 3: cells of 6 or 8 nodes
};

/// One side of one cell.
struct CellSide {
  Eigen::Index cell;  ///< number of the cell
  int side;           ///< from 0; side s joins the corners s and s + 1, the last one the last
                      ///< corner and the first; the body lies to its left
};

/// Triangles with 3 nodes and quadrilaterals with 4, alone or together; or triangles with 6 nodes and
/// quadrilaterals with 8 (serendipity), which have the midpoints of their sides after the corners.
///
/// The corners of a cell run counter-clockwise. A boundary is a list of cell sides; its order is
/// the order in which its nodes are met when walking along it.
struct Mesh {
  std::string name = "body";  ///< what messages call it
  NodeArray nodes;            ///< `n_nodes x 2` positions [length]
  /// `n_cells x 3`, 4, 6 or 8: the largest cell fills its row. Nodes of side s: corner s, corner s + 1, and
  /// `corners + s` in its middle. A triangle beside quadrilaterals has -1 after its 3 or 6 nodes.
  CellArray cells;
  std::map<std::string, std::vector<CellSide>> boundaries;  ///< by name
  /// Numbers of the cells of a part of the body, by name of the part; usually none.
  std::map<std::string, std::vector<Eigen::Index>> regions = {};

  /// \return number of nodes
  [[nodiscard]] Eigen::Index n_nodes() const { return nodes.rows(); }
  /// \return number of cells
  [[nodiscard]] Eigen::Index n_cells() const { return cells.rows(); }
  /// \return whether sides have 2 nodes or 3
  [[nodiscard]] MeshOrder order() const {
    return cells.cols() > 4 ? MeshOrder::Quadratic : MeshOrder::Linear;
  }
  /// \param cell  its number \return how many corners it has, and sides: 3 or 4
  [[nodiscard]] int corners(Eigen::Index cell) const {
    const Eigen::Index last = cells.cols() - 1;
    return last % 4 == 3 && cells(cell, last) >= 0 ? 4 : 3;
  }
  /// \param cell  its number \return how many nodes it has: 3, 4, 6 or 8
  [[nodiscard]] Eigen::Index cell_size(Eigen::Index cell) const {
    return cells.cols() > 4 ? 2 * corners(cell) : corners(cell);
  }
  /// Nodes of one cell side.
  /// \param side  must exist
  /// \return their numbers in walking order: 2, or 3 with the midpoint between the corners
  [[nodiscard]] std::vector<Eigen::Index> side_nodes(const CellSide& side) const;
};

/// Looks up a boundary.
/// \param mesh  that has it
/// \param name  of the boundary
/// \return its sides in walking order
/// \throws ProblemError if there is no such boundary; the message lists those that exist
[[nodiscard]] const std::vector<CellSide>& boundary(const Mesh& mesh, const std::string& name);

/// Nodes of a boundary.
/// \param mesh  that has it
/// \param name  of the boundary
/// \return node numbers in walking order, each once
/// \throws ProblemError if there is no such boundary
[[nodiscard]] std::vector<Eigen::Index> boundary_nodes(const Mesh& mesh, const std::string& name);

/// What check_mesh() measured. Both look at the corners only, as if sides were straight.
struct MeshQuality {
  double smallest_jacobian_ratio;  ///< worst over cells of min det J / max det J at corners [-]
  /// Worst over cells of longest side / shortest side; of a triangle, longest side / height on it,
  /// times \f$ \sqrt{3}/2 \f$ [-].
  double largest_aspect_ratio;
};

/// Looks at every cell and every boundary side.
///
/// \param mesh  its boundaries must name sides of existing cells
/// \return how far the worst cells are from parallelograms, and from squares and triangles of three equal
///   sides; 1 and 1 is best
/// \throws ProblemError naming the first cell (counted from 0) that refers to a node that does not
///   exist, is inverted or degenerate, or has a midpoint that is not within the middle half along
///   its side; the boundary that has a side of zero length; a number of nodes per cell other than 3, 4, 6
///   or 8; a position that is not finite; or a mesh that lies so far from the origin that coordinates are
///   rounded to more than a millionth of the height of a cell
MeshQuality check_mesh(const Mesh& mesh);

}  // namespace signorini

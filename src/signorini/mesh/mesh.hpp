/// \file
/// A mesh of quadrilaterals with named boundaries, and the checks that come before any computation.
#pragma once
#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

namespace signorini {

/// Positions or vectors of nodes, one row each.
using NodeArray = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;
/// Node numbers of cells, one row each.
using CellArray = Eigen::Matrix<Eigen::Index, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// One side of one cell. Side s joins the corners s and s+1; the body lies to the left of it.
struct CellSide {
  Eigen::Index cell;
  int side;
};

/// Quadrilaterals with 4 nodes, or with 8 (serendipity: 4 corners, then the midpoints of the sides).
///
/// The corners of a cell run counter-clockwise. A boundary is a list of cell sides; its order is the
/// order in which its nodes are met when walking along it.
struct Mesh {
  std::string name = "body";                                ///< what messages call it
  NodeArray nodes;                                          ///< `n_nodes x 2` positions [length]
  CellArray cells;                                          ///< `n_cells x 4` or `n_cells x 8`
  std::map<std::string, std::vector<CellSide>> boundaries;  ///< by name

  [[nodiscard]] Eigen::Index n_nodes() const { return nodes.rows(); }
  [[nodiscard]] Eigen::Index n_cells() const { return cells.rows(); }
  /// Nodes of one cell side in walking order: 2, or 3 with the midpoint between the corners.
  [[nodiscard]] std::vector<Eigen::Index> side_nodes(const CellSide& side) const;
};

/// The sides of the boundary `name`.
/// \throws ProblemError if there is no such boundary; the message lists those that exist
[[nodiscard]] const std::vector<CellSide>& boundary(const Mesh& mesh, const std::string& name);

/// Nodes of a boundary, each once, in walking order.
/// \throws ProblemError if there is no such boundary
[[nodiscard]] std::vector<Eigen::Index> boundary_nodes(const Mesh& mesh, const std::string& name);

/// What check_mesh() measured.
struct MeshQuality {
  double smallest_jacobian_ratio;  ///< worst over cells of min det J / max det J at the corners [-]
  double largest_aspect_ratio;     ///< longest side / shortest side of a cell [-]
};

/// Looks at every cell and every boundary side.
///
/// \throws ProblemError naming the first cell (counted from 0) that is inverted or degenerate, that
///   refers to a node that does not exist, or the boundary that has a side of zero length
MeshQuality check_mesh(const Mesh& mesh);

}  // namespace signorini

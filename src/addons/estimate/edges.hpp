// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The edges of a mesh, each once, and which of them can only be halved together.
#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "signorini/fem/mesh.hpp"

namespace signorini {

/// The sides of all cells, with those that two cells share counted once.
struct MeshEdges {
  /// `n_cells x 4`: number of the edge that each side of a cell is; -1 after the three of a triangle.
  Eigen::Array<Eigen::Index, Eigen::Dynamic, 4> of_cell;
  /// Of each edge the side of one cell, and that of the other; `cell` of the second is -1 on the outline.
  std::vector<std::array<CellSide, 2>> sides;

  /// \param side  of a cell \return the number of its edge
  [[nodiscard]] Eigen::Index at(const CellSide& side) const {
    return of_cell(side.cell, side.side);
  }
  /// \return number of edges
  [[nodiscard]] std::size_t size() const { return sides.size(); }
};

/// The edges of a mesh, and which of them are to be halved.
struct MarkedEdges {
  MeshEdges edges;           ///< of the mesh
  std::vector<char> halved;  ///< of each, how often it is to be: 0 if it stays
};

/// Finds the edges.
/// \param mesh  that passes check_mesh()
/// \return in the order of the smaller, then of the larger number of their end nodes
/// \throws ProblemError naming the nodes if more than two cells share an edge
[[nodiscard]] MeshEdges edges(const Mesh& mesh);

/// \param mesh   any
/// \param times  how often each edge is to be halved
/// \return its edges, all marked alike
/// \throws ProblemError as edges()
[[nodiscard]] MarkedEdges marked_alike(const Mesh& mesh, char times);

/// The longest side of a triangle.
/// \param mesh      that has it
/// \param triangle  number of a cell of three corners
/// \return its number, 0 to 2; of those that rounding cannot tell apart, the one whose middle is furthest left,
///   then lowest
[[nodiscard]] int longest_side(const Mesh& mesh, Eigen::Index triangle);

/// The *refinement lines* of a mesh: edges that are opposite sides of quadrilaterals, one after another, can only be halved
/// together. A line ends at the outline or at a triangle; an edge between triangles is one by itself.
/// \param mesh   any
/// \param edges  of it
/// \return number of the line of each edge, from 0, in the order of their first edges
[[nodiscard]] std::vector<Eigen::Index> refinement_lines(const Mesh& mesh, const MeshEdges& edges);

/// Which other edges must be halved so that no cell is left with a hanging node: with a side of a quadrilateral the
/// opposite one, as often; with a side of a triangle its longest, once.
/// \param mesh    any
/// \param edges   of it
/// \param halved  of each edge, how often it is to be halved
/// \return the same with the others
[[nodiscard]] std::vector<char> closed_under_halving(const Mesh& mesh, const MeshEdges& edges,
                                                     std::vector<char> halved);

}  // namespace signorini

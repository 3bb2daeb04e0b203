/// \file
/// How the cells of a mesh hang together: its pieces and its outer sides.
///
/// The equations of a body that is cut in two are as good as those of a whole one. So a mesh that
/// should be whole and is not can only be found by looking at its cells, before anything is solved.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "signorini/fem/mesh.hpp"

namespace signorini {

/// Cells that hang together by common nodes.
struct MeshPiece {
  std::vector<Eigen::Index> nodes;  ///< their numbers, increasing
  Eigen::Index cells = 0;           ///< how many there are
};

/// The pieces of a mesh.
/// \param mesh  whose cells refer to existing nodes
/// \return in the order of their first nodes; a node that belongs to no cell is in none
[[nodiscard]] std::vector<MeshPiece> pieces(const Mesh& mesh);

/// Where a piece is.
/// \param mesh   that has it
/// \param piece  one of its pieces
/// \return middle of the box around its nodes [length]
[[nodiscard]] Eigen::Vector2d middle(const Mesh& mesh, const MeshPiece& piece);

/// What messages call a piece.
/// \param mesh   that has it
/// \param piece  one of its pieces
/// \return such as "8 cells around (2, 0.5)"
[[nodiscard]] std::string in_words(const Mesh& mesh, const MeshPiece& piece);

/// The sides that belong to one cell only, with their nodes in this order: the outline of a mesh, and both
/// faces of its cracks.
/// \param mesh  that passes check_mesh()
/// \return in the order of cells and their sides
[[nodiscard]] std::vector<CellSide> outer_sides(const Mesh& mesh);

}  // namespace signorini

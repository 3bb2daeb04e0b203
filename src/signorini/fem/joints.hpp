/// \file
/// How the cells of a mesh hang together: its pieces, its outer sides, and nodes that lie on these without
/// belonging to them.
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

/// A node that lies on an outer side without being one of its nodes.
struct LooseNode {
  Eigen::Index node;   ///< its number
  CellSide side;       ///< that it lies on
  Eigen::Index other;  ///< node of the side in the same place; -1 if it hangs between the nodes
};

/// Finds nodes that lie on an outer side without belonging to it: nothing holds the cells together there.
/// Near is what is nearer than a thousandth of the shortest side of the cells there, which is more than what
/// positions lose that are written with six digits.
/// \param mesh  that passes check_mesh()
/// \return one entry per node at most, by number, but only one for two that lie in one place
[[nodiscard]] std::vector<LooseNode> loose_nodes(const Mesh& mesh);

}  // namespace signorini

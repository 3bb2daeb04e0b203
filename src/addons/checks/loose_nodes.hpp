// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Nodes that lie on an outer side of a mesh without belonging to it.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/fem/joints.hpp"

namespace signorini {

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

// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// How the two sides of a contact stand to each other, for warnings.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/contact/pairs.hpp"

namespace signorini {

/// Nodes that lie behind a target.
struct PenetratingNodes {
  std::vector<Eigen::Index> nodes;  ///< of the source, by number
  double farthest = 0;  ///< how far behind the target the farthest of them lies [length]
};

/// Finds the nodes that lie behind all places of the target that they face, deeper than the cells there, and
/// not in the target's body: they have passed through it.
/// \param source  the boundary that may touch (slave)
/// \param target  the boundary that may be touched (master)
/// \return none in a scene that is meant well, unless the source reaches around the target
/// \throws ProblemError if there is no such boundary
[[nodiscard]] PenetratingNodes penetrating_nodes(const Surface& source, const Surface& target);

}  // namespace signorini

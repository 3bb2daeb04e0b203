// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The gaps between the nodes of one boundary and a rigid obstacle.
#pragma once
#include "signorini/contact/gap_operators.hpp"
#include "signorini/contact/obstacle.hpp"
#include "signorini/contact/pairs.hpp"

namespace signorini {

/// One pair per node of a boundary. \PaperEq{XuanLi2002, 13}
///
/// The normal points out of the obstacle, so that u along it opens the gap. The weight of a node is the
/// integral of its shape function along the boundary times the depth: half a side at the ends of
/// a linear boundary, 1/6 and 4/6 of a side for the corners and midpoints of a quadratic one.
/// \param source    the boundary that may touch (slave)
/// \param obstacle  the target (master)
/// \param options   nodes, depth, and whether slips are wanted; nothing is integrated
/// \return pairs in the order of boundary_nodes()
/// \throws ProblemError if the boundary does not exist, or if the obstacle gives a gap or a normal that
///   is not finite
[[nodiscard]] Pairs node_to_obstacle(const Surface& source, const Obstacle& obstacle,
                                     const GapOptions& options);

}  // namespace signorini

// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Where the normal jumps between two points of a source edge.
#pragma once
#include <vector>

#include "addons/motion/kept_points.hpp"

namespace signorini {

/// The places from which on a source faces the next side of its target, at the same distance but with another
/// normal. None where it faces the vertex between the two sides for a while: the normal turns with the point there. At a
/// node between two edges the place may move either way: each of them has half.
/// \param edges      of the source in walking order, cut into segments
/// \param interface  of source and target
/// \return two for each place, one per end of the edge: in the place of the pair the node at that end, and in that of the
///   share its dual function there
[[nodiscard]] std::vector<KeptJump> jumps_along(const std::vector<SampledEdge>& edges,
                                                const Interface& interface);

}  // namespace signorini

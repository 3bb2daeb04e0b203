// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// How far a mesh lies from the origin, and what its coordinates have lost to rounding there.
///
/// Drawings in national coordinates lie millions of metres from the origin. The library keeps
/// differences of coordinates apart from coordinates where it can; what is lost already, these two
/// numbers tell.
#pragma once
#include "signorini/fem/mesh.hpp"

namespace signorini {

/// \param nodes  `n x 2`, one at least [length]
/// \return distance of the origin from the box around them; 0 if it lies inside [length]
[[nodiscard]] double distance_from_origin(const NodeArray& nodes);

/// \param mesh  whose cells refer to existing nodes \param cell  any
/// \return the shortest of its sides, each from corner to corner [length]
[[nodiscard]] double shortest_side(const Mesh& mesh, Eigen::Index cell);

/// How well a mesh knows the directions of its sides: the largest coordinate is rounded the most, and the shortest side
/// turns the most by it.
/// \param mesh  whose cells refer to existing nodes
/// \return what one rounding does to a direction [-], epsilon at least
[[nodiscard]] double direction_rounding(const Mesh& mesh);

}  // namespace signorini

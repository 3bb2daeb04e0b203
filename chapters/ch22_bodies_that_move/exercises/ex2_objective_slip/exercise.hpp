/// \file
/// Exercise 22.2 - slip along a side that moves. Do not change this file.
#pragma once
#include <Eigen/Core>

namespace ex22_2 {

using Eigen::Vector2d;

/// Where things are at one time [length].
struct Scene {
  Vector2d node;   ///< of the source
  Vector2d first;  ///< one end of the side of the target
  Vector2d last;   ///< its other end, elsewhere
};

/// The place on the line through the side that is nearest to the node.
/// \param scene  any
/// \return 0 at the first end, 1 at the last; also below 0 or above 1 [-]
[[nodiscard]] double place_faced(const Scene& scene);

/// How far the node has slid along the side.
/// \param before  at the end of the last step
/// \param now     where they are
/// \return > 0 from the first end towards the last, in lengths of before; the same if all that is `now` is moved or turned [length]
[[nodiscard]] double slip(const Scene& before, const Scene& now);

}  // namespace ex22_2

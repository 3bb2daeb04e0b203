/// \file
/// Exercise 14.4 - pressures on a bent outline. Do not change this file.
#pragma once
#include <Eigen/Core>

namespace ex14_4 {

/// Whether the last node of an outline is joined to its first one.
enum class Outline { Open, Closed };

/// Pressures at the nodes of an outline with straight sides, from the forces on them.
///
/// Half of each side belongs to each of its ends. A uniform pressure on all sides makes forces on all nodes, and from them comes out
/// again at all nodes, however long the sides are and whatever the angles are at which they meet. Of other forces only the
/// component counts that a pressure on the two sides would have.
/// \param position  `n x 2` nodes [length], body on the left of who walks along
/// \param force     `n x 2` on the nodes [force/length]
/// \param outline   of an open one, the first and the last node have one side only
/// \return `n` pressures [force/length^2], compression > 0
/// \throws std::invalid_argument if sizes differ, there are fewer than two nodes, of a closed outline three, or the pressures on
///   the two sides of a node cancel each other exactly
[[nodiscard]] Eigen::VectorXd pressures(const Eigen::MatrixX2d& position,
                                        const Eigen::MatrixX2d& force, Outline outline);

}  // namespace ex14_4

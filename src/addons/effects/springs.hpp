// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Springs that hold a body to the ground.
#pragma once
#include <Eigen/SparseCore>
#include <vector>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// What springs add to K: along a boundary the integral of the products of its shape functions, so that they
/// feel the displacements between the nodes.
/// \param mesh     the body
/// \param depth    across the plane; a spring at one node is that of the whole depth
/// \param springs  several at one place add up
/// \return `2 n_nodes` square, row and column 2 * node + axis; symmetric, positive semidefinite; joins nodes of one
///   side in the same direction [force/length]
/// \throws ProblemError if a stiffness is negative or not finite, or as nodes_at()
[[nodiscard]] Eigen::SparseMatrix<double> spring_stiffness(const Mesh& mesh, const Depth& depth,
                                                           const std::vector<Spring>& springs);

/// Adds the springs of a body to K, and to p what they feel of given displacements.
/// \param body  one of them
/// \param[in,out] programme  K and p of all bodies
void add_springs(const BodyModel& body, QuadraticProgramme& programme);

}  // namespace signorini

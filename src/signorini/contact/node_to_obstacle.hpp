/// \file
/// The gaps between the nodes of one boundary and a rigid obstacle.
#pragma once
#include <string>

#include "signorini/contact/gaps.hpp"
#include "signorini/contact/obstacle.hpp"
#include "signorini/contact/pairs.hpp"
#include "signorini/elasticity/unknowns.hpp"
#include "signorini/mesh/mesh.hpp"

namespace signorini {

/// One pair per node of a boundary.
///
/// The normal points out of the obstacle, so that u along it opens the gap. The weight of a node is the
/// integral of its shape function along the boundary times the thickness: half a side at the ends of
/// a linear boundary, 1/6 and 4/6 of a side for the corners and midpoints of a quadratic one.
/// \param source     the boundary that may touch (slave)
/// \param obstacle   the target (master)
/// \param n_nodes    of all bodies
/// \param thickness  of the body across the plane [length]
/// \param sliding    whether slips are wanted too
/// \return pairs in the order of boundary_nodes()
/// \throws ProblemError if the boundary does not exist, or if the obstacle gives a gap or a normal that
///   is not finite
[[nodiscard]] Pairs node_to_obstacle(const Surface& source, const Obstacle& obstacle,
                                     Eigen::Index n_nodes, double thickness, bool sliding = false);

/// The same for a single body, of nodes that can still move along their normal. \PaperEq{XuanLi2002, 13}
/// \param mesh       of the body, the source (slave)
/// \param boundary   its boundary that may touch
/// \param obstacle   the target (master)
/// \param unknowns   `n` numbered displacements of the mesh
/// \param thickness  of the body across the plane [length]
/// \return the gaps of `n_c` pairs, in the order of boundary_nodes()
/// \throws ProblemError if the boundary does not exist or is held by supports across whole sides,
///   if a held node overlaps the obstacle, which no contact force can undo, or if the obstacle
///   gives a gap that is not finite
[[nodiscard]] Gaps node_to_obstacle(const Mesh& mesh, const std::string& boundary,
                                    const Obstacle& obstacle, const Unknowns& unknowns,
                                    double thickness);

}  // namespace signorini

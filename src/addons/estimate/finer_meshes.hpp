// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The next meshes of a scene: marked edges are halved, once and again, as long as the meshes can be solved.
#pragma once
#include <string>
#include <vector>

#include "addons/estimate/marking.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini {

/// Finer meshes, or why there are none.
struct FinerMeshes {
  std::vector<Mesh> meshes;   ///< of all bodies
  Eigen::Index unknowns = 0;  ///< two for each of their nodes
  int halvings = 0;           ///< how often marked edges were halved; 0: there is an obstacle
  std::string obstacle;       ///< why what is still marked was not halved; empty: it was
  bool too_many = false;      ///< the obstacle is the number of unknowns
};

/// \param marks  any \return whether an edge is marked
[[nodiscard]] bool any_marked(const std::vector<MarkedEdges>& marks);

/// Halves what is marked, and what it faces, see mark_facing(). What cannot be done the second time is left for later.
/// \param contacts       of the scene
/// \param bodies         of its model
/// \param marks          of their edges
/// \param most_unknowns  that the meshes may have
/// \return the last meshes that pass check_mesh() and have no more unknowns
[[nodiscard]] FinerMeshes finer_meshes(const std::vector<ContactSpec>& contacts,
                                       std::vector<BodyModel> bodies,
                                       std::vector<MarkedEdges> marks, Eigen::Index most_unknowns);

}  // namespace signorini

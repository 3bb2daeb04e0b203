// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The pairs of a contact, found in the meshes as they are.
#pragma once
#include <vector>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// Pairs of one contact by its operator, before supports.
/// \param contact   of the scene
/// \param bodies    of the scene
/// \param sliding   whether the matrix S is wanted
/// \param standing  of bodies that have moved to where the meshes have them; or null
/// \return the pairs
/// \throws ProblemError as GapOperator and node_to_obstacle(), or for bodies of two thicknesses
[[nodiscard]] Pairs pair_up(const ContactSpec& contact, const std::vector<BodyModel>& bodies,
                            bool sliding, const Standing* standing = nullptr);

/// A contact that has been paired.
struct FollowedContact {
  ContactSpec contact;  ///< of the scene
  Eigen::VectorXd gap;  ///< of the pairs that supports leave, in the meshes before fit() [length]
  bool linear = false;  ///< whether its gaps are taken as linear and are not searched again, as of a sliding tie
  std::vector<Eigen::Index> given = {};  ///< nodes of all bodies, increasing, whose pairs were left out: equations hold them
};

}  // namespace signorini

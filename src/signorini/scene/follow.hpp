// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The pairs of a scene: found in the meshes as they are, and found again where bodies have moved to.
#pragma once
#include <vector>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// The pairs of a model where its bodies have moved to.
struct MovedPairs {
  /// N `n_c x 2 n_nodes` of the pairs of the model [-]; of one that faces nothing there as it was
  NodalRows opening;
  /// `n_c` by how much gaps exceed those of the meshes [length]; infinite of a pair that faces nothing there
  Eigen::VectorXd opens;
  /// `n_c` the longest of the sides that a pair is on or faced in the meshes [length]
  Eigen::VectorXd edge;
  /// N `k x 2 n_nodes` of places that overlap there and were in no pair of the model [-]
  NodalRows fresh;
  Eigen::VectorXd fresh_gap;               ///< `k` < 0 [length]
  std::vector<std::size_t> fresh_contact;  ///< `k` number of the contact of each
  /// Of each contact why none of its pairs faces anything there; empty if some do
  std::vector<std::string> lost;
};

/// Pairs of one contact by its operator, before supports.
/// \param contact  of the scene
/// \param bodies   of the scene
/// \param sliding  whether the matrix S is wanted
/// \return the pairs
/// \throws ProblemError as GapOperator and node_to_obstacle(), or for bodies of two thicknesses
[[nodiscard]] Pairs pair_up(const ContactSpec& contact, const std::vector<BodyModel>& bodies,
                            bool sliding);

/// A contact that has been paired.
struct FollowedContact {
  ContactSpec contact;  ///< of the scene
  Eigen::VectorXd gap;  ///< of the pairs that supports leave, in the meshes before fit() [length]
};

/// \param contacts  all of a scene, in its order
/// \return what finds their pairs again
[[nodiscard]] FollowPairs follow(std::vector<FollowedContact> contacts);

}  // namespace signorini

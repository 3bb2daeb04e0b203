// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The pairs of a scene, found again where bodies have moved to.
#pragma once
#include <vector>

#include "signorini/scene/pair_up.hpp"

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

/// Finds the pairs of a model again where its bodies have moved to.
/// \param contacts      all of the scene, in its order
/// \param model         with its bodies and pairs
/// \param displacement  `n_nodes x 2` of all nodes [length]
/// \return the pairs there
[[nodiscard]] MovedPairs follow(const std::vector<FollowedContact>& contacts, const Model& model,
                                const NodeArray& displacement);

}  // namespace signorini

// Scenes that are the same but for their units, or for the numbers of their nodes.
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "signorini/scene/scene.hpp"

namespace signorini_test {

/// The scene in other units: every length times `length`, every force times `force`.
signorini::Scene in_units(signorini::Scene scene, double length, double force);

/// A scene and where its nodes went.
struct Renumbered {
  signorini::Scene scene;
  std::vector<std::vector<Eigen::Index>> place;  ///< of every old node in the new mesh, per body
};

/// The scene with the nodes of each body in another order.
Renumbered renumbered(signorini::Scene scene, std::uint64_t seed);

}  // namespace signorini_test

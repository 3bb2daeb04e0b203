// Random scenes in which one body slides over another, and the contact forces where the bodies have come to.
#pragma once
#include <cstdint>
#include <string>

#include "signorini/scene/scene.hpp"

namespace signorini_test {

/// A scene with one contact, and what it is, in words.
struct SlidingScene {
  signorini::Scene scene;
  std::string text;
};

/// The scene of a seed: a block whose lower side is flat, round or wavy is pressed on another, on a half plane, a disc, into
/// a hole or on a wavy obstacle, and moved along it by 1/256 to 16 of its edges; with friction or without, at once or in
/// load steps, some forth and back.
/// \param seed  names it \return the scene, with ContactSpec::small_sliding as it is by default
SlidingScene sliding_scene(std::uint64_t seed);

/// What is said of a scene, and what is true: of pairs that follow the bodies.
///
/// With these every step is solved again and again, with gaps, normals and rows of the meshes where the last solution has
/// moved their nodes to, until they stay there; strains stay small, so K stays. Only plan() and what comes after build()
/// are asked for it, nothing that knows that bodies move.
struct SlidingTrial {
  std::string text;    ///< the scene, and what was said
  bool found = false;  ///< whether there is an end both ways
  /// By how much the force and the sum of the normal forces differ at most, in any step, over that sum with pairs that stay
  /// [-]; infinite if there is none
  double change = 0;
  bool refused = false;  ///< whether the scene ends as `SlidTooFar`
  bool noted = false;    ///< whether it is solved, with a note on its sliding
};

/// Solves a scene both ways. \param seed  of sliding_scene() \return what came of it
SlidingTrial try_sliding(std::uint64_t seed);

}  // namespace signorini_test

/// \file
/// The bodies whose factors this chapter counts.
#pragma once
#include <string>

#include "../../tests/support/cantilever.hpp"
#include "signorini/core/ledger.hpp"

namespace ch21 {

using namespace signorini;
using Eigen::Index;

/// The cantilever of chapter 6: ten times longer than high, its whole lower side a candidate.
/// \param cells  over its height \param element  of the cells \return the scene, in kN and cm
inline Scene cantilever(Index cells, const std::string& element = "q4_incompatible") {
  return signorini_test::cantilever(element, 10 * cells, cells);
}

/// A square of the same height and material, held at its left side, above the same foundation.
/// \param cells  on each side \return the scene
inline Scene square(Index cells) {
  Scene scene = cantilever(cells, "q4");
  scene.bodies[0].mesh = block("square", {0, 0}, {5, 5}, cells, cells);
  return scene;
}

/// \param scene  any \return its K, p, A, g
inline Model built(const Scene& scene) {
  Ledger unused;
  return build(scene, unused);
}

}  // namespace ch21

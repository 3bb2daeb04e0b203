/// \file
/// The scenes of this chapter besides those of the figure of errors.
#pragma once
#include <string>

#include "runs.hpp"
#include "signorini/mesh/block.hpp"

namespace ch16 {

/// \param cells  of disc and plate on 1.3 half-widths; their nodes meet \return Hertz's contact
inline Scene hertz(Index cells) { return signorini_test::hertz(meshes(cells, cells)); }

/// The cantilever of chapter 6: ten times longer than high, its whole lower side a candidate.
/// \param cells  over its height \return the scene, in kN and cm
inline Scene cantilever(Index cells) {
  BlockSpec spec;
  spec.name = "cantilever";
  spec.size = {50, 5};
  spec.cells_x = 10 * cells;
  spec.cells_y = cells;
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = make_block(spec);
  body.material = {2.1e4, 0.29, PlaneState::Stress, 1};
  body.supports = {fixed("left")};
  body.loads.edges = {{"top", 3.6, {}}};
  scene.contacts = {{{"bottom"}, half_plane({0, -1}, {0, 1})}};
  return scene;
}

/// \param cells  over its height \return its K, p, A, g
inline Model built_cantilever(Index cells) {
  Ledger unused;
  return build(cantilever(cells), unused);
}

}  // namespace ch16

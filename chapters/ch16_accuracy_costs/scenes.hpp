/// \file
/// The scenes of this chapter besides those of the figure of errors.
#pragma once
#include <string>

#include "../../tests/support/cantilever.hpp"
#include "runs.hpp"

namespace ch16 {

/// \param cells  of disc and plate on 1.3 half-widths; their nodes meet \return Hertz's contact
inline Scene hertz(Index cells) { return signorini_test::hertz(meshes(cells, cells)); }

/// The cantilever of chapter 6: ten times longer than high, its whole lower side a candidate.
/// \param cells  over its height \return the scene, in kN and cm
inline Scene cantilever(Index cells) {
  return signorini_test::cantilever("q4_incompatible", 10 * cells, cells);
}

}  // namespace ch16

// Random scenes made odd, or wrong: extreme and absurd numbers, names of nothing, broken meshes.
#pragma once
#include "support/random_bodies.hpp"

namespace signorini_test {

/// Changes up to three things in a scene.
///
/// Odd are numbers over hundreds of decades, loads or supports that are gone, bodies far from the origin, bodies that
/// pass through each other, other boundaries that touch, any solver of the library. Wrong are numbers that are none or
/// out of their range, names of nothing, sides and nodes that do not exist, entries that contradict each other.
/// \param draw            what is drawn next; says what was changed
/// \param[in,out] scene   of whatever kind
/// \return whether the scene now has something that no scene may have: it must be refused
bool spoil(Draws& draw, signorini::Scene& scene);

}  // namespace signorini_test

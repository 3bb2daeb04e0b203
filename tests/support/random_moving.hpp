// Random scenes of bodies that move.
#pragma once
#include "support/random_bodies.hpp"

namespace signorini_test {

/// A tool that is pressed on a longer base and dragged along it, to and fro or all the way, in 3 to 12 steps.
///
/// Base and tool are flat, wavy or round, coarse or fine, of linear or quadratic cells or of triangles, in plane strain or
/// stress, or, where the base is a ring around the tool, of revolution; their stiffness differs by up to six decades, strains
/// are 1e-6 to 5e-3. In half of the scenes one of them has a law of finite strain, or both, and is pressed by up to a fifth
/// of its height. Any side is the source; friction to 0.5, with cohesion sometimes; the tool is moved or loaded, touches, overlaps or is near; units over six decades, far from the origin
/// by up to 100 lengths, and turned by a right angle.
/// \param draw  what is drawn next
/// \return a scene with load steps
signorini::Scene random_moving(Draws& draw);

}  // namespace signorini_test

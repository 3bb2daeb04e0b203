// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What is refused of a scene before its meshes are looked at.
#pragma once
#include "signorini/scene/scene.hpp"

namespace signorini {

/// Refuses a scene that cannot be meant, or that this program does not know all effects of. \param scene  any
/// \throws ProblemError if there is no body, two have one name, the solver or the back end is no member of its family, an
///   effect is called for that no add-on of the program has, or something follows a history without load steps
void check_scene(const Scene& scene);

}  // namespace signorini

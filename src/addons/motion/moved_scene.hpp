// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What the effects of bodies that move ask of a scene, and hand to its plan.
#pragma once
#include "signorini/scene/scene.hpp"

namespace signorini {

/// Checks the contacts of a scene whose bodies move, and gives the plan their loop.
/// \param scene  with load steps
/// \param[in,out] draft  with bodies
/// \throws ProblemError if there are no load steps, or a contact cannot be found where bodies have moved to
void move_pairs(const Scene& scene, Plan& draft);

}  // namespace signorini

/// \file
/// Exercise 18.4 - the same scene without one effect. Do not change this file.
#pragma once
#include <string>

#include "signorini/scene/scene.hpp"

namespace ex18_4 {

/// Takes one effect out of a scene, wherever in it, and nothing else: the plan of what is returned has the effect among those that
/// are off, and all others as they were.
/// \param scene   without load steps; may have the effect in several bodies or contacts, or not at all
/// \param effect  "body force", "edge loads", "point forces", "layers", "temperature", "springs", "adjusted gaps", "interference",
///   "friction" or "cohesion"
/// \return the scene without the effect
/// \throws std::invalid_argument for any other name: what a body is, how it is held and whether it touches are no switches
[[nodiscard]] signorini::Scene without(signorini::Scene scene, const std::string& effect);

}  // namespace ex18_4

// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Lengths by which the effects "adjusted gaps" and "interference" bring the two sides of a contact together.
#pragma once
#include <string>
#include <vector>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// Compares a length of a contact with how thick its bodies are: their area over the length of the side in contact.
/// \param contact  of the scene
/// \param bodies   of the scene
/// \param name     of the length
/// \param length   its `adjust` or `interference` [length]
/// \return a note if the length is more; else empty
[[nodiscard]] std::string fit_warning(const ContactSpec& contact,
                                      const std::vector<BodyModel>& bodies, const std::string& name,
                                      double length);

}  // namespace signorini

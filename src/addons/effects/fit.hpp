// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// How two sides fit before anything moves: what the effects "adjusted gaps" and "interference" have the effect
/// "contact" do. The lengths are those of the meshes, so this comes before supports move anything.
#pragma once
#include <string>
#include <vector>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// Brings the sides of a contact together as it says: small gaps adjusted first, then its interference.
/// \param contact       whose lengths have been checked
/// \param[in,out] pairs  of the meshes; gets new initial gaps
/// \return what was done, to go on a line about the pairs; nothing if the contact asks for nothing
[[nodiscard]] std::string fit(const ContactSpec& contact, Pairs& pairs);

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

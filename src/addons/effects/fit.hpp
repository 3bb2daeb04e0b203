/// \file
/// How two sides fit before anything moves: what the effects "adjusted gaps" and "interference" have the effect
/// "contact" do. The lengths are those of the meshes, so this comes before supports move anything.
#pragma once
#include <string>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// Brings the sides of a contact together as it says: small gaps adjusted first, then its interference.
/// \param contact       whose lengths have been checked
/// \param[in,out] pairs  of the meshes; gets new initial gaps
/// \return what was done, to go on a line about the pairs; nothing if the contact asks for nothing
[[nodiscard]] std::string fit(const ContactSpec& contact, Pairs& pairs);

}  // namespace signorini

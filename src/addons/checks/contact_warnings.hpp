// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Contacts that are seldom meant.
#pragma once
#include <string>
#include <vector>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// Looks at where the two sides of a contact are.
/// \param contact  of the scene
/// \param bodies   of the scene
/// \param pairs    of the contact, of which supports have taken none yet
/// \return notes on source nodes that face no target or have passed through it, on an obstacle that no node
///   faces, and on one that rises between two nodes that do not see it
[[nodiscard]] std::vector<std::string> contact_warnings(const ContactSpec& contact,
                                                        const std::vector<BodyModel>& bodies,
                                                        const Pairs& pairs);

}  // namespace signorini

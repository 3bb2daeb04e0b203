// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Contacts that cannot be meant, or seldom are.
#pragma once
#include <string>
#include <vector>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// Looks for contacts that pair the same sides, the same way round or the other.
/// \param scene   whose contacts are looked at
/// \param bodies  of the scene
/// \throws ProblemError naming both contacts; rigid obstacles are the same if all nodes that both contacts have
///   see the same gap and normal
void check_listed_once(const Scene& scene, const std::vector<BodyModel>& bodies);

/// Looks at where the two sides of a contact are.
/// \param contact  of the scene
/// \param bodies   of the scene
/// \param pairs    of the contact, of which supports have taken none yet
/// \return notes on source nodes that face no target or have passed through it, and on an obstacle that no node
///   faces
/// \throws ProblemError if the normal of an obstacle points into it: no node is in front of it, and some look
///   the same way
[[nodiscard]] std::vector<std::string> contact_warnings(const ContactSpec& contact,
                                                        const std::vector<BodyModel>& bodies,
                                                        const Pairs& pairs);

}  // namespace signorini

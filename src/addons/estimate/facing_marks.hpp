// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Sides that touch are refined together where they are curved.
#pragma once
#include <vector>

#include "addons/estimate/marking.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini {

/// Marks the sides that marked sides of a contact of two meshes face, where one of the two is curved: chords of a circle
/// leave gaps and overlaps, which two meshes only have in common if their sides are as long. A side that is shorter
/// by more than the root of 2 is left alone.
/// \param contacts  of the scene
/// \param bodies    of the plan or the model
/// \param[in,out] marks  of each body; closed under halving in the end
void mark_facing(const std::vector<ContactSpec>& contacts, const std::vector<BodyModel>& bodies,
                 std::vector<MarkedEdges>& marks);

}  // namespace signorini

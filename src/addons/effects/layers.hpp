// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Parts of a body that are of other materials.
#pragma once
#include <vector>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// Puts layers into a body.
/// \param mesh    the body
/// \param base    material of the cells that are in no layer
/// \param layers  of regions of the mesh
/// \return the material of every cell
/// \throws ProblemError if there is no such region, a cell is in two layers, or a layer has another thickness or
///   plane state, or as check_material()
[[nodiscard]] MaterialField layered(const Mesh& mesh, const Material& base,
                                    const std::vector<Layer>& layers);

}  // namespace signorini

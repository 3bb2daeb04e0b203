// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Supports and springs that bear a force where there is no area to bear it.
#pragma once
#include <string>
#include <vector>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// Looks at what holds single nodes, or sides on the axis of a body of revolution, and at springs there. Under a force at
/// a point, or in axial symmetry on a line of radius 0, an elastic body gives way without bound: the finer the mesh, the
/// further, and what bears it bears less and less if something else can. A component that a whole side of a cell holds is
/// borne by that side. Forces of less than half the digits of the loads are rounding, as of supports that only keep a body
/// from moving rigidly. Scenes with equations are not looked at: these bring forces of whole sides to single nodes.
/// \param model     from build()
/// \param solution  of it, Solved
/// \return a note on each body that is held so, on its supports and on its springs; none if they bear nothing
[[nodiscard]] std::vector<std::string> point_supports(const Model& model, const Solution& solution);

}  // namespace signorini

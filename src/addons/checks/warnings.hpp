// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What is legal but seldom meant: notes of a plan and of a solution.
#pragma once
#include <string>
#include <vector>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// Looks at how the cells of a body hang together.
/// \param scene   of the body: what touches across a crack is meant
/// \param body    one of its bodies, with its pieces
/// \return notes on loose pieces, on nodes that coincide, and on hanging nodes
[[nodiscard]] std::vector<std::string> mesh_warnings(const Scene& scene, const BodyModel& body);

/// Looks at the loads of a body.
/// \param body  of a scene; its boundaries exist
/// \return notes on loads that are zero everywhere, on pressures of the size of Young's modulus, and on tractions
///   along a boundary with two ends that add up to neither force nor moment
[[nodiscard]] std::vector<std::string> load_warnings(const Body& body);

/// Looks at whether a solution is one for which linear elasticity can be meant, in one pass over the cells.
/// \param model     from build()
/// \param solution  of it, Solved
/// \param limits    that are noted where they are exceeded
/// \return notes on large strains, rotations and pressures, and on contact in which no pair carries a force
[[nodiscard]] std::vector<std::string> solution_warnings(const Model& model,
                                                         const Solution& solution,
                                                         const SmallLimits& limits = {});

}  // namespace signorini

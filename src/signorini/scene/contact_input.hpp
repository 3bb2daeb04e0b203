// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Contacts that cannot be meant: plan() refuses them, because their answers would be wrong.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// Looks for contacts that pair the same sides, the same way round or the other.
/// \param scene   whose contacts are looked at
/// \param bodies  of the scene
/// \throws ProblemError naming both contacts; rigid obstacles are the same if all nodes that both contacts have
///   see the same gap and normal
void check_listed_once(const Scene& scene, const std::vector<BodyModel>& bodies);

/// Looks at which side of a rigid obstacle a body is on.
/// \param contact  of the scene; nothing is looked at if its target is a body
/// \param bodies   of the scene
/// \param pairs    of the contact, of which supports have taken none yet
/// \throws ProblemError if the normal of the obstacle points into it: no node is in front of it, and some look
///   the same way
void check_obstacle_side(const ContactSpec& contact, const std::vector<BodyModel>& bodies,
                         const Pairs& pairs);

/// A cosine up to this says neither that a normal points towards a body nor that it points away [-].
constexpr double aside = 1e-6;

/// Which way nodes of the source look when seen from the target.
/// \param pairs   `n_c` of node_to_obstacle() or node_to_segment(), all with a node
/// \param source  the boundary they are on
/// \return `n_c` cosine of the angle between the normals of both sides: -1 face to face, 1 if both look the
///   same way [-]
[[nodiscard]] Eigen::VectorXd normal_cosines(const Pairs& pairs, const Surface& source);

}  // namespace signorini

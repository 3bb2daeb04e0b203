// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Whether the resultants that are told are those of the forces that were certified.
#pragma once
#include "signorini/scene/solution.hpp"

namespace signorini {

/// Adds up, for every body, the contact and friction forces of its pairs along their normals and tangents, and again what
/// the rows of A hand to its nodes; and so the moments about the middle of the body.
///
/// Equilibrium of the nodes, which certify() looks at, and this are together the balance of loads, supports and
/// resultants.
/// \param model     from build()
/// \param contact   the forces that are told
/// \param certified  the forces of all rows of A
/// \return the largest difference [-]: of forces over the largest force of a pair, of moments over that times the largest
///   distance of a node from the middle; in axial symmetry of the forces along the axis only; 0 without contact
[[nodiscard]] double imbalance(const Model& model, const ContactState& contact,
                               const Eigen::VectorXd& certified);

}  // namespace signorini

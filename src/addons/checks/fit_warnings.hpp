// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Gaps that straight edges make, or that end up closed, over lengths that are seldom meant.
#pragma once
#include <string>
#include <vector>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// Compares the gaps of a contact with what straight edges make of them: a node of the source that faces the middle of an
/// edge of a round target is farther from it than from the curve, by the sag of the edge.
/// \param contact  of the scene
/// \param bodies   of the scene
/// \param pairs    of the contact as the meshes give them, before fit()
/// \return a note if that is more than the mean gap and than what the contact adjusts or presses by; else none
[[nodiscard]] std::vector<std::string> sag_warning(const ContactSpec& contact,
                                                   const std::vector<BodyModel>& bodies,
                                                   const Pairs& pairs);

/// Compares gaps that were closed with the sizes of bodies.
/// \param model     that was solved
/// \param solution  of it, Solved
/// \return a note on a pair that carries a force and has closed a gap larger than the smaller of its bodies; else none
[[nodiscard]] std::vector<std::string> closed_gap_warnings(const Model& model,
                                                           const Solution& solution);

}  // namespace signorini

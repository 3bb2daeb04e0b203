// Whether loads, supports, springs and the resultants of contacts that are told are in balance, body by body.
#pragma once
#include "signorini/scene/solution.hpp"

namespace signorini_test {

/// Adds up, for every body, loads, springs, supports and the resultants of its contacts, as they are printed, and their
/// moments about its middle. What supports do is read from stresses, whose rounding in stiff bodies is taken off.
/// \param model     from build(), without load steps
/// \param solution  of it, solved
/// \return the largest sum over the largest of what is added up, of moments over that times the size of the body; in axial
///   symmetry of the forces along the axis only
double unbalanced(const signorini::Model& model, const signorini::Solution& solution);

}  // namespace signorini_test

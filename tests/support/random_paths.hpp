// Random histories for the loads of random scenes.
#pragma once
#include "support/random_bodies.hpp"

namespace signorini_test {

/// Lets a scene go through five steps.
///
/// What presses, heats or widens grows, stays, wavers or goes to zero and back; what drags or moves supports also turns
/// round. Tractions come apart from pressures, so that each has a history of its own; some loads are there from the
/// first step on.
/// \param draw            what is drawn next
/// \param[in,out] scene   without load steps
void add_path(Draws& draw, signorini::Scene& scene);

}  // namespace signorini_test

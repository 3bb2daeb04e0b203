// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// One load step of bodies that move.
#pragma once
#include "signorini/scene/step_loop.hpp"

namespace signorini {

/// Writes pairs, gaps and slips of a model where its bodies stand, counted from there: see place_bodies().
using PlacePairs =
    std::function<void(const Displaced& displacement, const Displaced& before, Model& model)>;

/// The loop of linearised contact problems of a step, see StepLoop: at the present u, forces, pairs, gaps and slips are written
/// anew, the linear problem is solved and certified as any other, and the way d that it finds leads to the next u. It ends when
/// the certificate holds of the equations that are found where the bodies then stand. So no equation of
/// the step is one of a place that the bodies have left.
///
/// Under small strain the loop has one factor; under finite strain each iteration has the tangent of its place. How contact forces
/// turn, friction too, is a load: see corrected_solve(). If no pairs can be
/// found where an iteration leads to, or a cell inverts, it goes half of the way, and again, as often as the path of the scene
/// halves a step.
/// \param place  of the scene
/// \return a loop that places bodies by it
[[nodiscard]] StepLoop moving_step(PlacePairs place);

}  // namespace signorini

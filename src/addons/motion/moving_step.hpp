// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// One load step of bodies whose pairs change partners.
#pragma once
#include "signorini/scene/step_loop.hpp"

namespace signorini {

/// The loop of linearised contact problems of a step, see StepLoop: at the present u, pairs, gaps and slips are written anew,
/// the linear problem with the same factor of K is solved and certified as any other, and its u is the next one. It ends when
/// what was solved holds where it leads to: when the certificate holds of the pairs that are found there. So no equation of
/// the step is one of a place that the bodies have left.
///
/// The gaps are \f$ g(u) \f$, the loop is Newton's method without the change of normals and of places, and each iteration leaves
/// of the error about four times the strain. If no pairs can be found where an iteration leads to, it goes half of the
/// way, and again, as often as the path of the scene halves a step.
/// \param place  of the scene
/// \return a loop that places bodies by it
[[nodiscard]] StepLoop moving_step(decltype(StepLoop::place) place);

}  // namespace signorini

// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Whether bodies are in balance as a whole, or rounding of K has taken their forces.
#pragma once
#include "signorini/scene/solution.hpp"

namespace signorini {

/// Looks at what a rigid motion of each body feels: nothing, whatever u is, if K had all digits. Every entry of K is rounded, though,
/// so that it holds a body like weak springs. A certificate with this K as its data knows nothing of that. Where a body is so
/// slender, so nearly incompressible or so much softer than another one that these springs bear a part of its load, this adds a note,
/// from a millionth of the forces on, or withdraws the solution, from a hundredth on.
/// \param model      that was solved
/// \param condensed  from condense() of it
/// \param[in,out] solution  of it, Solved
void check_lost_digits(const Model& model, const Condensed& condensed, Solution& solution);

}  // namespace signorini

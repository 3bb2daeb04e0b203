// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Whether a solution that takes sliding for small can be meant.
#pragma once
#include "signorini/scene/solution.hpp"

namespace signorini {

/// Looks at how far the pairs of a solution have slid: adds notes, or withdraws it as `SlidTooFar`.
/// \param model      that was solved
/// \param condensed  from condense() of it
/// \param[in,out] solution  of it, Solved
void check_sliding(const Model& model, const Condensed& condensed, Solution& solution);

}  // namespace signorini

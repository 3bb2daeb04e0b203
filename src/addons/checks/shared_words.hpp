// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What is told of pairs that share what they carry.
#pragma once
#include <string>

#include "signorini/scene/solution.hpp"

namespace signorini {

/// The note on pairs whose forces are not determined.
/// \param model     that was solved
/// \param solution  of it
/// \param least     narrower ranges count as determined [force]
/// \return sentences: all pairs; of the widest group how far the first forces go, the sum if that is determined, and the way
///   out; empty if all are determined
[[nodiscard]] std::string shared_forces_in_words(const Model& model, const Solution& solution,
                                                 double least);

/// Finds which forces of a solution could as well be others, and adds a note on them. \param model  that was solved
/// \param condensed  not asked
/// \param[in,out] solution  of it, Solved; gets `shared`
void note_shared_forces(const Model& model, const Condensed& condensed, Solution& solution);

}  // namespace signorini

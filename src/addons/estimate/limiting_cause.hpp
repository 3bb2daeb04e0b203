// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What stands in the way of an accuracy.
#pragma once
#include <string>

#include "addons/estimate/accuracy.hpp"

namespace signorini {

/// Says which part of the error is the largest, and where, or what no estimate foresees.
///
/// Where the source of a contact that presses ends at a node that is held in both directions, pressures grow
/// without bound, and more of them is seen with every mesh: such an end is named.
/// \param run  with one round or more
/// \return in words
[[nodiscard]] std::string limiting_cause(const AccurateSolution& run);

}  // namespace signorini

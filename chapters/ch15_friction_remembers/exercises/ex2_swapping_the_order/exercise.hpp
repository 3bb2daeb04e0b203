/// \file
/// Exercise 15.2 - one end of a path, in another order. Do not change this file.
#pragma once
#include <string>

#include "addons/steps/histories.hpp"
#include "signorini/scene/scene.hpp"

namespace ex15_2 {

/// Lets one history come first. Until half of the time it grows in proportion from 0 to its value at the end of the
/// path, and stays; all others are 0 until then, and grow to theirs in the other half.
/// \param scene  with a path of equal steps
/// \param first  name of a history
/// \return the scene with other histories, as many equal steps to the same end, or one more if their number is odd
/// \throws std::invalid_argument if the scene has no path, or no history of that name
[[nodiscard]] signorini::Scene in_order(signorini::Scene scene, const std::string& first);

}  // namespace ex15_2

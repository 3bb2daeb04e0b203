/// \file
/// Histories of load steps, and the effect that sorts loads by them.
#pragma once
#include <string>
#include <vector>

#include "signorini/scene/path.hpp"

namespace signorini {

/// Adds load steps to effects(). A program whose scenes have load steps calls it before it plans one; a program that is
/// linked with all of the library, signorini::signorini, need not.
void register_load_steps();

/// Checks a history. \param history  any
/// \throws ProblemError unless its times are finite and increase and it has as many finite values
void check_history(const History& history);

/// \param name  of the history \return 0 at time 0, 1 at time 1, straight between
[[nodiscard]] History proportional(const std::string& name);

/// \param steps  how many, at least 1 \param end  time of the last one, > 0 [time]
/// \return `steps` times at equal distances, the last one `end` [time]
[[nodiscard]] std::vector<double> equal_steps(int steps, double end = 1);

}  // namespace signorini

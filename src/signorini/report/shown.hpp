/// \file
/// A solved scene with its plan before it and its ledger after it, for programs that people watch.
#pragma once
#include <string>

#include "signorini/scene/readings.hpp"

namespace signorini {

/// Solves as solved(). The first scene of a program is also printed: what is on and off, and what it cost.
/// \param scene  to be solved
/// \param what   what it is called
/// \return as solved() \throws NotSolved, ProblemError as solved()
[[nodiscard]] SolvedScene shown(const Scene& scene, const std::string& what);

}  // namespace signorini

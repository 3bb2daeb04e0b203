// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// How long this machine takes for some cells of every body, just now.
#pragma once
#include "signorini/scene/scene.hpp"

namespace signorini {

/// Seconds of what goes through all cells, from a few of every body.
struct Sample {
  double assembly = 0;  ///< of K [s]
  double residual = 0;  ///< of one residual in twice the working precision [s]
};

/// Assembles some cells of every body, and forms their residual.
/// \param plan               from plan()
/// \param stiffness_entries  of K of all bodies
/// \return what all of them will take
/// \throws ProblemError as assemble() of these cells
[[nodiscard]] Sample sample_of(const Plan& plan, Eigen::Index stiffness_entries);

}  // namespace signorini

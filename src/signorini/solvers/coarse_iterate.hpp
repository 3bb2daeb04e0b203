/// \file
/// A start for primal_dual_active_set() where many pairs overlap.
#pragma once
#include "signorini/solvers/iterate.hpp"

namespace signorini {

/// Where to start from. Of many overlapping pairs most will open.
///
/// Where 64 pairs or more overlap, every second one of them is solved alone by primal_dual_iterations(), from those of
/// these again, until few are left; closed at the start are then the pairs between closed ones. It saves most of
/// the steps, and those that it costs are on smaller problems.
/// \param problem  scaled; with friction or rigid modes the start is first_iterate()
/// \return the start; its report counts the factorisations
[[nodiscard]] Iterate coarse_iterate(const ScaledProblem& problem);

}  // namespace signorini

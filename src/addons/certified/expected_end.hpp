// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// A solution that was expected, corrected for what the pairs do.
#pragma once
#include <vector>

#include "signorini/solvers/refined_solve.hpp"

namespace signorini {

/// Corrects an expected solution once, and lets the certificate say whether that is the end. If it is not, refinement
/// begins from it.
/// \param of        statuses `n_c` \param expected  u in two parts, and forces in balance with the load; no rigid modes
/// \param[in,out] sets  of the problem: go on from there
/// \return whether all signs are right, and the certificate is ten times better than it must be
[[nodiscard]] bool ends_as_expected(const std::vector<ContactStatus>& of, PrimalDual expected,
                                    RefinedSets& sets);

}  // namespace signorini

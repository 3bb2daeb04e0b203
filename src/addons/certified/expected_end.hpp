// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// A solution that was expected, where the pairs do what was expected of them.
#pragma once
#include <vector>

#include "signorini/solvers/refined_solve.hpp"

namespace signorini {

/// Takes an expected solution for the end, if other forces would be so by rounding only, and the certificate agrees.
/// \param of        statuses `n_c` \param expected  u and forces, each in two parts; no rigid modes
/// \param[in,out] sets  of the problem, before the first set: has the end, or is as before
/// \return whether it is the end: all signs are right, and the certificate is ten times better than it must be
[[nodiscard]] bool ends_as_expected(const std::vector<ContactStatus>& of, const PrimalDual& expected,
                                    RefinedSets& sets);

}  // namespace signorini

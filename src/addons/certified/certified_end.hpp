// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What is said of the best set when no other is tried any more.
#pragma once
#include "addons/certified/certified_solve.hpp"

namespace signorini {

/// Ends a certified_solve(). If the certificate of the best set holds, that is the solution: what its pairs do is read off
/// its numbers unless all its signs are right, tension that is rounding becomes 0, and how well its forces are known is
/// estimated. If not, the set is first refined once more such that u bears the work that the rounded entries of K do along
/// rigid motions. A proof that nothing solves the problem is kept if proves_infeasible() says so of the original data.
/// \param sets         all that was refined
/// \param[in,out] end  of these sets; its state gets status, reason and the numbers of the best set
void conclude(RefinedSets& sets, CertifiedSolution& end);

}  // namespace signorini

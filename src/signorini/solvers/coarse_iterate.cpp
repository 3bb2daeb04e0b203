// # A start from every second pair
//
// The exchange of all wrong pairs begins with the pairs that overlap without contact. On a long
// boundary most of these open again, set by set, and each set costs a factorisation: about
// \f$ \tfrac13 m^3 \f$ operations for m closed pairs. With every second pair only, a factorisation
// costs an eighth, and the closed pairs are nearly in the same places. So the small problem is
// solved first and tells where the large one begins. Its own start comes from half of its pairs,
// and so on: 256 overlapping pairs start from 128, these from 64, and these from 32. Methods that
// go from coarse to fine in this way are called *nested iteration*.
//
// The start may be wrong everywhere. It changes the number of sets and not the solution.

#include <algorithm>
#include <vector>

#include "signorini/core/index.hpp"
#include "signorini/solvers/iterate.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"

namespace signorini {
namespace {

using Eigen::Index;

// Fewer overlapping pairs than these are exchanged as fast as a start for them is found.
constexpr std::size_t many = 64;

}  // namespace

// The small problem has no mesh of its own: it is the rows and columns of every second overlapping
// pair. A pair between two of them starts closed if both are closed. This takes pairs with
// neighbouring numbers for neighbours on the boundary.
Iterate coarse_iterate(const ScaledProblem& problem) {
  Iterate iterate = first_iterate(problem);
  const std::vector<Index> overlapping = closed_pairs(iterate.statuses);
  if (!problem.law.pair.empty() || problem.rigid.cols() > 0 || overlapping.size() < many)
    return iterate;
  std::vector<Index> half;
  for (std::size_t k = 0; k < overlapping.size(); k += 2) half.push_back(overlapping[k]);
  const ScaledProblem coarse{problem.compliance(half, half), problem.free(half),
                             problem.scale(half), problem.symmetric};
  Iterate found = coarse_iterate(coarse);
  primal_dual_iterations(coarse, most_exchanges(coarse), found);
  iterate.report.factorisations = found.report.factorisations;
  if (!found.confirmed) return iterate;
  const auto opens = [&](std::size_t k) {
    return found.statuses[std::min(k, half.size() - 1)] == ContactStatus::Open;
  };
  for (std::size_t k = 0; k < overlapping.size(); ++k)
    if (opens(k / 2) || opens((k + 1) / 2))
      iterate.statuses[at(overlapping[k])] = ContactStatus::Open;
  return iterate;
}

}  // namespace signorini

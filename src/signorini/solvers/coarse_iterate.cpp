#include "signorini/solvers/coarse_iterate.hpp"

#include <algorithm>
#include <vector>

#include "signorini/core/index.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// Fewer overlapping pairs than these are exchanged as fast as a start for them is found.
constexpr std::size_t many = 64;

}  // namespace

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

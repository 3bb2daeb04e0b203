#include <algorithm>
#include <iterator>

#include "exercise.hpp"
#include "signorini/core/dense.hpp"

namespace ex5_5 {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Pairs that pull though closed, or overlap though open.
Rows wrong_pairs(const signorini::ContactProblem& problem, const Rows& closed) {
  VectorXd force = VectorXd::Zero(problem.free_gap.size());
  if (!closed.empty()) {
    const signorini::CholeskyFactor factor(problem.compliance(closed, closed));
    force(closed) = factor.solve(-problem.free_gap(closed));
  }
  const VectorXd gap = problem.free_gap + problem.compliance * force;
  Rows wrong;
  for (Index i = 0; i < gap.size(); ++i) {
    const bool is_closed = std::binary_search(closed.begin(), closed.end(), i);
    if ((is_closed ? force(i) : gap(i)) < -1e-12) wrong.push_back(i);
  }
  return wrong;
}

}  // namespace

std::vector<Rows> closed_pairs(const signorini::ContactProblem& problem, std::size_t limit) {
  std::vector<Rows> sets = {wrong_pairs(problem, {})};
  while (sets.size() < limit) {
    const Rows& closed = sets.back();
    const Rows wrong = wrong_pairs(problem, closed);
    if (wrong.empty()) break;
    Rows next;  // in one of the two lists, but not in both: your changes around here
    std::set_symmetric_difference(closed.begin(), closed.end(), wrong.begin(), wrong.end(),
                                  std::back_inserter(next));
    sets.push_back(next);
  }
  return sets;
}

}  // namespace ex5_5

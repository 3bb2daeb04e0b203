// # The sparse system of an active set
//
// In a pile of rigid bodies a force moves only the bodies that it acts on, so F has few entries. A dense factor of
// a thousand pairs would fill all of them.
//
// Such piles are also undetermined: many forces hold the same bodies. \f$ \sqrt\epsilon \f$ on the diagonal, minus
// that for the modes, makes any such system regular. The error that it makes is taken away by the sweeps
// of solve_active_set(), which use F itself: each sweep leaves \f$ \sqrt\epsilon \f$ over an eigenvalue of it. Of
// what the system does not determine the sweeps leave what they began with.

#include <cmath>
#include <memory>

#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/sparse_lu.hpp"
#include "signorini/problem/active_set_system.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

// The matrix of general_system(), by its entries, with \f$ \pm\sqrt\epsilon \f$ on the diagonal.
SparseMatrix regular_matrix(const ScaledProblem& problem, const ActiveSet& set) {
  const Index m = static_cast<Index>(set.closed.size());
  const Index k = problem.rigid.cols();
  // Where a row of the problem stands in the system, or -1.
  std::vector<Index> place(at(problem.free.size()), -1);
  for (Index i = 0; i < m; ++i) place[at(set.closed[at(i)])] = i;
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](Index row, Index column, double slope) {
    for (SparseMatrix::InnerIterator entry(problem.sparse, row); entry; ++entry)
      if (const Index there = place[at(entry.row())]; there >= 0)
        entries.emplace_back(there, column, slope * entry.value());
    for (Index j = 0; j < k; ++j)
      entries.emplace_back(m + j, column, slope * problem.rigid(row, j));
  };
  for (Index i = 0; i < m; ++i) {
    const Index row = set.closed[at(i)];
    add(row, i, 1);
    for (Index j = 0; j < k; ++j) entries.emplace_back(i, m + j, problem.rigid(row, j));
  }
  // A friction force stands in the column of its normal force.
  for (const SlidingPair& pair : set.sliding) add(pair.slip, place[at(pair.gap)], pair.slope);
  // Minus for the modes keeps the form of a saddle point: plus for W, minus for what multiplies it.
  for (Index i = 0; i < m + k; ++i)
    entries.emplace_back(i, i, (i < m ? 1 : -1) * std::sqrt(epsilon));
  SparseMatrix M(m + k, m + k);
  M.setFromTriplets(entries.begin(), entries.end());
  return M;
}

}  // namespace

// The entries of rows and modes are those of general_system(); the column of a normal force has the friction
// force of its pair in it, with its slope. Where even that is singular to rounding, the dense system has the last word.
ActiveSetSystem sparse_system(const ScaledProblem& problem, const ActiveSet& set) {
  const Index k = problem.rigid.cols();
  // The factor is shared by the copies of the function that solves with it.
  const auto factor = std::make_shared<SparseLuFactor>();
  // An empty set of held bodies has no system at all.
  if (set.closed.empty() && k == 0) return general_system(problem, set);
  if (!factor->factorise(regular_matrix(problem, set))) return general_system(problem, set);
  ActiveSetSystem system{set.closed, (factor->sign() < 0) != (k % 2 == 1)};
  // One vector goes in and comes out: forces first, then amplitudes.
  system.solve = [factor](const VectorXd& top, const VectorXd& bottom) {
    VectorXd right(top.size() + bottom.size());
    right << top, bottom;
    const VectorXd both = factor->solve(right);
    return std::make_pair(VectorXd(both.head(top.size())), VectorXd(both.tail(bottom.size())));
  };
  return system;
}

}  // namespace signorini

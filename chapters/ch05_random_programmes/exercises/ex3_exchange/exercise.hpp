/// \file
/// Exercise 5.3 - the exchange method, by pivots. Do not change this file.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/problem/problem.hpp"

namespace ex5_3 {

using Eigen::Index;

/// The equations y = q + M x of all pairs. Of an open pair y is the gap and x the force, of a closed one y is the force
/// and x the gap; so all x are zero now, and y = q.
struct Table {
  Eigen::MatrixXd M;         ///< `n_c x n_c`, numbers of the order of 1
  Eigen::VectorXd q;         ///< `n_c`
  std::vector<bool> closed;  ///< `n_c`
};

/// Lets one pair change sides: x and y of this pair change their places in the equations.
/// \param[in,out] table  the same equations, solved for other variables
/// \param pair           which
/// \throws std::invalid_argument if there is no such pair, or M_ii is not above 1e-12; the table is as before then
void exchange(Table& table, Index pair);

/// One step: all pairs that are on the wrong side, with y below -1e-12, change sides.
/// \param[in,out] table  as above
/// \return the pairs that have changed, in increasing order
/// \throws std::invalid_argument as exchange()
std::vector<Index> exchange_wrong_pairs(Table& table);

/// How the loop ended.
struct Run {
  bool solved = false;
  Eigen::VectorXd force;  ///< lambda `n_c` of the last table
  int steps = 0;          ///< of the method
  int exchanges = 0;      ///< of single pairs
};

/// The method without a safeguard, driven by your functions.
/// \param problem  G and d
/// \param limit    on steps
/// \return forces, and what they cost
inline Run drive(const signorini::ContactProblem& problem, int limit) {
  const Index n = problem.free_gap.size();
  Table table{problem.compliance, problem.free_gap, std::vector<bool>(static_cast<std::size_t>(n))};
  Run run{false, Eigen::VectorXd::Zero(n)};
  while (!run.solved && run.steps < limit) {
    const auto changed = static_cast<int>(exchange_wrong_pairs(table).size());
    run.solved = changed == 0;
    run.steps += changed > 0 ? 1 : 0;
    run.exchanges += changed;
  }
  for (Index i = 0; i < n; ++i)
    if (table.closed[static_cast<std::size_t>(i)]) run.force(i) = table.q(i);
  return run;
}

}  // namespace ex5_3

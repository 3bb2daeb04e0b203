// # All sets of closed pairs
//
// Each of n pairs is open or closed, so there are \f$ 2^n \f$ sets of closed pairs. If the set W is
// known, the rest is linear:
// \f[ G_{WW}\lambda_W = -d_W, \qquad \lambda_i = 0 \;\text{for all other pairs}, \qquad g = d + G\lambda. \f]
// W is right if no force pulls and no gap overlaps. So one can simply try all sets. This is slow:
// 12 pairs have 4096 sets, and 40 pairs have about \f$ 10^{12} \f$. But it cannot cycle or stop too
// early. For a positive definite G exactly one set of forces solves the problem, and this method
// finds it. Other methods are compared with it.
//
// The three carts, with G = [1 1 1; 1 2 2; 1 2 3] and d = (-2, -1, -3), have eight sets. The sixth
// in the order of this file is {1, 3}. Its forces are 1.5 and 0.5, and its middle gap is 1.5. The
// last two sets have as many pairs or more and are skipped.

#include "signorini/solvers/enumerate.hpp"

#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/problem/farkas.hpp"

namespace signorini {

using Eigen::Index;

namespace {

// A set is a number whose binary digits say which pairs are closed: 5 is 101 and stands for {1, 3}.
std::vector<Index> members(unsigned set, Index n) {
  std::vector<Index> list;
  for (Index i = 0; i < n; ++i)
    if ((set >> i & 1U) != 0) list.push_back(i);
  return list;
}

// The proof that nothing solves a problem, or nothing: one that no smaller one is part of has
// independent pairs and one that depends on them. Two rows that point against each other, G = [1
// -1; -1 1] with d = (-1, -1), are an example. The sum of the two gaps is -2 whatever the forces
// are, so one of them overlaps. In general numbers \f$ y \ge 0 \f$ with \f$ Gy = 0 \f$ and
// \f$ d^Ty < 0 \f$ are the proof, called a Farkas certificate; here y = (1, 1).
Eigen::VectorXd proof(const ScaledProblem& scaled) {
  const Index n = scaled.free.size();
  for (unsigned set = 0; set < (1U << n); ++set)
    for (Index pair = 0; pair < n; ++pair) {
      if ((set >> pair & 1U) != 0) continue;
      Eigen::VectorXd y = farkas_certificate(scaled, members(set, n), pair);
      if (y.size() > 0) return y;
    }
  return {};
}

}  // namespace

// A pair that touches without a force may be called open or closed. The set with the fewest pairs
// is returned: once a solution is known, only smaller sets are tried. A set whose rows repeat each
// other is left out, because a smaller set gives the same displacements.
ContactState enumerate(const ContactProblem& problem, const SolverOptions& /*options*/) {
  check_plain(problem, "enumerate");
  const Index n = problem.free_gap.size();
  require_argument(n <= largest_enumeration, "enumerate: accepts at most ", largest_enumeration,
                   " pairs, got ", n);
  const ScaledProblem scaled = equilibrate_any(problem);
  Report report;
  ActiveSetSolution best;
  best.force.setZero(n);
  best.movement = scaled.free;
  std::vector<Index> best_active;
  for (unsigned set = 0; set < (1U << n); ++set) {
    const std::vector<Index> active = members(set, n);
    if (report.status == SolveStatus::Solved && active.size() >= best_active.size()) continue;
    ActiveSetSolution now = solve_active_set(scaled, ActiveSet{active});
    ++report.iterations;
    report.factorisations += active.empty() ? 0 : 1;
    if (now.rows.size() < active.size() || !solves(scaled, statuses_of(active, n), now)) continue;
    best = std::move(now);
    best_active = active;
    report.status = SolveStatus::Solved;
  }
  Eigen::VectorXd y;
  if (report.status != SolveStatus::Solved && scaled.symmetric) y = proof(scaled);
  if (y.size() > 0) report.status = SolveStatus::Infeasible;
  return finished(problem, scaled, best, statuses_of(best_active, n), std::move(report),
                  std::move(y));
}

}  // namespace signorini

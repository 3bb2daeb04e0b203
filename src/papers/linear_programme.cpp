// # Contact as a linear programme
//
// Xuan and Li compare the results of two examples with those of a paper whose title names a linear
// programme in increments. The simplex method finds gaps and forces that are not negative; a rule of its exchanges sees to it
// that no pair has both. The tableau is in [simplex_tableau.cpp](simplex_tableau.cpp). This file
// runs it, once for the whole load or in increments.
//
// Each pivot exchanges one pair, so there are at least as many pivots as closed pairs. Each changes
// a table of \f$ n \times 2n \f$ numbers. With 100 closed pairs of 1000 that is a hundred changes of
// two million numbers.

#include "papers/linear_programme.hpp"

#include <utility>

#include "papers/simplex_tableau.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/problem/active_set_system.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

// Pivots until no artificial number is left, or the rule names no pivot. \return whether the limit allows that
bool pivot_to_end(SimplexTableau& tableau, double first_sum, Index limit, Report& report) {
  for (;; ++report.iterations) {
    const Index column = tableau.feasible() ? -1 : tableau.entering();
    const Index row = column < 0 ? -1 : tableau.leaving(column);
    if (row < 0) return true;
    if (report.iterations >= limit) return false;
    tableau.pivot(row, column);
    report.history.push_back(tableau.summary(first_sum));
  }
}

// Hundreds of pivots leave rounding errors in the tableau. So its last basis is only a guess of the
// closed pairs, which is then solved exactly. If that is no solution, the tableau is made anew from
// this basis, without the errors, and the pivots go on; if nothing has changed after that, the
// method has come to its end.
// The history has an entry per pivot.
ContactState run(const ContactProblem& problem, const ScaledProblem& scaled,
                 const std::vector<Index>& start, const SolverOptions& options) {
  const Index n = scaled.free.size();
  const Index limit = options.iteration_limit > 0 ? options.iteration_limit : 100 * n + 100;
  SimplexTableau tableau(scaled, start);
  const double first_sum = tableau.artificial_sum();
  Report report;
  report.status = SolveStatus::IterationLimit;
  report.factorisations = start.empty() ? 0 : 1;
  VectorXd proof;
  Index rebuilt = -1;  // pivots before it
  while (report.status == SolveStatus::IterationLimit &&
         pivot_to_end(tableau, first_sum, limit, report)) {
    // No artificial number is left, or none but rounding, or the rule stalls.
    const std::vector<Index> closed = tableau.closed();
    report.factorisations += closed.empty() ? 0 : 1;
    if (auto end = confirmed(scaled, closed)) {
      report.status = SolveStatus::Solved;
      return finished(problem, scaled, end->first, end->second, std::move(report));
    }
    proof = tableau.proof();
    if (proof.size() > 0) {
      report.status = SolveStatus::Infeasible;
    } else if (rebuilt == report.iterations) {
      report.status = SolveStatus::Breakdown;
    } else {  // once more from this basis, without the rounding errors of the pivots
      tableau = SimplexTableau(scaled, closed);
      ++report.factorisations;
      rebuilt = report.iterations;
    }
  }
  if (proof.size() > 0) proof = scaled.scale.cwiseProduct(proof);
  return finished(problem, scaled, tableau.numbers(), statuses_of(tableau.closed(), n),
                  std::move(report), std::move(proof));
}

}  // namespace

// The whole load at once starts with all pairs open.
// All gaps are in the first basis then, and the artificial variables are the overlaps without
// contact. No factorisation is needed to begin.
ContactState linear_programme(const ContactProblem& problem, const SolverOptions& options) {
  check_plain(problem, "linear_programme");
  return run(problem, equilibrate(problem), {}, options);
}

// Gaps without contact are linear in the load, so an increment is a point on the line between the
// gaps without load and those with all of it. Its closed pairs are almost those of the next
// increment, and with small increments each has few pivots. What an increment leaves negative at
// the start of the next one becomes artificial there.
//
// If an increment is not solved, the next ones have no start, and the run ends.
// The last increment takes the gaps as they were given, so that no rounding of the line between is
// left in them.
std::vector<ContactState> incremental_linear_programme(const ContactProblem& problem,
                                                       const VectorXd& initial_gap,
                                                       Index increments,
                                                       const SolverOptions& options) {
  check_plain(problem, "incremental_linear_programme");
  ScaledProblem scaled = equilibrate(problem);
  require_argument(initial_gap.size() == problem.free_gap.size() && initial_gap.allFinite(),
                   "incremental_linear_programme: need ", problem.free_gap.size(),
                   " finite initial gaps, got ", initial_gap.size());
  require_argument(increments > 0, "incremental_linear_programme: need at least 1 increment, got ",
                   increments);
  std::vector<ContactState> states;
  for (Index k = 1; k <= increments; ++k) {
    const double t = static_cast<double>(k) / static_cast<double>(increments);
    const VectorXd gap =
        k == increments ? problem.free_gap : (1 - t) * initial_gap + t * problem.free_gap;
    scaled.free = scaled.scale.cwiseProduct(gap);
    states.push_back(run({problem.compliance, gap}, scaled,
                         states.empty() ? std::vector<Index>() : states.back().active(), options));
    if (states.back().report.status != SolveStatus::Solved) break;
  }
  return states;
}

}  // namespace signorini

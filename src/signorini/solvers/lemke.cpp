// # Lemke's method
//
// Of each pair one number is zero, the gap \f$ w_i \f$ or the force \f$ z_i \f$, and the equations
// are \f$ w = Mz + q \f$. Lemke (1965) adds a number \f$ z_0 \f$ that opens all gaps at once,
// \f[ w = Mz + c\,z_0 + q, \qquad c > 0. \f]
// For a large \f$ z_0 \f$ no force is needed. The method leads \f$ z_0 \f$ to zero and keeps all
// other conditions on the way. At every corner of the path one variable becomes zero and leaves.
// Its partner, the other number of the same pair, enters: when a gap closes its force may grow, and
// when a force vanishes its gap may open. No choice is left, forwards or backwards. So no corner
// comes back, and the path ends after finitely many pivots in one of two ways. Either \f$ z_0 \f$
// leaves, and the problem is solved. Or nothing blocks the entering variable: a *ray*.
//
// Two pairs with M = [2 1; 1 2] and q = (-7, -5) need three pivots.
//
//     z_0 = 7:  w_1 leaves, z_1 enters
//     z_0 = 3:  w_2 leaves, z_2 enters; z_1 = 2 here
//     z_0 = 0:  z_0 leaves; z_1 = 3, z_2 = 1
//
// The numbers of each dictionary are in [dictionary.cpp](dictionary.cpp), and what the last one says
// of the problem in [end_of_pivots.cpp](end_of_pivots.cpp).
//
// The method asks little of M. It needs no symmetry and no energy, so it also solves problems with
// friction: [lemke_path.cpp](lemke_path.cpp). The price is that pairs join one by one, and that
// some problems take \f$ 2^n \f$ pivots.

#include "signorini/solvers/lemke.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/solvers/end_of_pivots.hpp"
#include "signorini/solvers/lemke_path.hpp"

namespace signorini {
namespace {

using Eigen::Index;

// Every path is finite, but \f$ 2^n \f$ pivots are too many to wait for. The bound stops growing
// that fast at 20 pairs.
Index limit_of(Index n, const SolverOptions& options) {
  return options.iteration_limit > 0 ? options.iteration_limit
                                     : (Index{1} << std::min<Index>(n, 20)) + 100 * n;
}

// One path, of at most `limit` pivots. If no pair overlaps without forces there is nothing to do.
// The limit is looked at last, so that a path that arrives with its last pivot has arrived.
EndOfPivots pivoted(const ScaledProblem& scaled, const Eigen::VectorXd& covering, Index limit) {
  const Index n = scaled.free.size();
  Report report;
  Dictionary dictionary(scaled, covering);
  if (n == 0 || (scaled.free.array() >= 0).all()) return last_basis(scaled, dictionary, report);
  Index entering = dictionary.artificial();
  Index row = dictionary.first_row();
  while (true) {
    const Index leaving = dictionary.basic(row);
    dictionary.pivot(row, entering);
    ++report.iterations;
    if (leaving == dictionary.artificial()) return last_basis(scaled, dictionary, report);
    entering = dictionary.partner(leaving);
    row = dictionary.blocking_row(entering);
    if (row < 0) return ray(scaled, dictionary, entering, report);
    if (report.iterations == limit) break;
  }
  report.status = SolveStatus::IterationLimit;
  return last_point(scaled, dictionary, report);
}

// Ones first; then entries from 1 to 2 in the order of the multiples of the golden section, which
// are spread evenly, shifted from path to path. A problem that takes \f$ 2^n \f$ pivots with one
// covering vector may take few with another. Random vectors would do as well, but two runs would
// then differ.
Eigen::VectorXd covering_of_path(Index n, Index path) {
  const double golden = (std::sqrt(5.0) - 1) / 2;
  Eigen::VectorXd covering = Eigen::VectorXd::Ones(n);
  for (Index i = 0; i < n && path > 0; ++i) {
    const double multiple = golden * static_cast<double>(n * (path - 1) + i + 1);
    covering(i) += multiple - std::floor(multiple);
  }
  return covering;
}

// Scales back to the units of the problem, where the certificate is computed once more.
ContactState state_of(const ContactProblem& problem, const ScaledProblem& scaled, EndOfPivots end) {
  return finished(problem, scaled, end.solution, end.statuses, std::move(end.report),
                  std::move(end.proof));
}

}  // namespace

// With a covering vector of the caller there is one path. Its entries are lengths, as those of q
// are, and are scaled with the rows.
ContactState lemke(const ContactProblem& problem, const Eigen::VectorXd& covering,
                   const SolverOptions& options) {
  check_plain(problem, "lemke with a covering vector");
  const ScaledProblem scaled = equilibrate_any(problem);
  const Index n = problem.free_gap.size();
  require_argument(covering.size() == n && covering.allFinite() && (covering.array() > 0).all(),
                   "lemke: the covering vector must have ", n,
                   " positive entries, one per pair, got ", covering.size(),
                   covering.size() > 0 ? text(", the least ", covering.minCoeff()) : "");
  return state_of(problem, scaled,
                  pivoted(scaled, scaled.scale.cwiseProduct(covering), limit_of(n, options)));
}

// Without one, a path that grows long is left, and a new one begins with another vector. Each path
// may be twice as long as the one before. If every vector needed the same number of pivots, the
// paths that are left would cost less than twice that number.
ContactState lemke(const ContactProblem& problem, const SolverOptions& options) {
  if (problem.resultant.size() > 0) check_problem(problem);
  const ScaledProblem scaled = equilibrate_any(problem);
  if (!problem.law.pair.empty() || problem.resultant.size() > 0) {
    Iterate iterate = first_iterate(scaled);
    follow_pivots(scaled, options, iterate);
    return finished(problem, scaled, std::move(iterate));
  }
  const Index n = problem.free_gap.size();
  const Index limit = limit_of(n, options);
  Index pivots = 0;
  Index length = n * n + 100 * n;
  for (Index path = 0;; ++path) {
    EndOfPivots end = pivoted(scaled, covering_of_path(n, path), std::min(length, limit - pivots));
    pivots = end.report.iterations += pivots;
    if (end.report.status != SolveStatus::IterationLimit || pivots >= limit)
      return state_of(problem, scaled, std::move(end));
    length *= 2;
  }
}

}  // namespace signorini

#include "signorini/solvers/lemke.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/farkas.hpp"
#include "signorini/solvers/dictionary.hpp"
#include "signorini/solvers/lemke_path.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// The proof that nothing solves a problem, if forces in a ratio of these give one; otherwise empty.
Eigen::VectorXd proof(const ScaledProblem& scaled, const Eigen::VectorXd& direction) {
  // Some of the smallest entries may be rounding; they are left out digit by digit.
  for (double small = epsilon; small < 1; small *= 10) {
    const double least = small * direction.maxCoeff();
    std::vector<Index> support =
        by_falling(direction.unaryExpr([=](double x) { return x > least ? x : 0; }));
    if (support.empty()) break;
    const Index pair = support.front();
    support.erase(support.begin());
    Eigen::VectorXd y = farkas_certificate(scaled, support, pair);
    if (y.size() > 0) return y;
  }
  return {};
}

/// Where a path ended, in scaled numbers.
struct End {
  ActiveSetSolution solution;
  std::vector<ContactStatus> statuses;
  Report report;
  Eigen::VectorXd proof = {};
};

/// Forces and gaps of the last basis, from the data.
End end_of_path(const ScaledProblem& scaled, const Dictionary& dictionary, Report report) {
  const Index n = scaled.free.size();
  Eigen::VectorXd force = Eigen::VectorXd::Zero(n);
  std::vector<Index> active;
  for (Index i = 0; i < n; ++i)
    if (dictionary.basic(i) >= n) {
      active.push_back(dictionary.basic(i) - n);
      force(active.back()) = dictionary.value()(i);
    }
  std::sort(active.begin(), active.end());
  End end{solve_active_set(scaled, ActiveSet{active}), statuses_of(active, n), std::move(report)};
  end.report.factorisations = active.empty() ? 0 : 1;
  end.report.status =
      solves(scaled, end.statuses, end.solution) ? SolveStatus::Solved : SolveStatus::Breakdown;
  if (end.report.status == SolveStatus::Solved || !scaled.symmetric) return end;
  // Rounding took a pair that touches without force into the basis, or one that depends on the others.
  if (end.solution.solvable && end.solution.rows.size() == active.size())
    force = end.solution.force;
  if (auto found = confirmed(scaled, by_falling(force))) {
    end.report.status = SolveStatus::Solved;
    std::tie(end.solution, end.statuses) = std::move(*found);
    return end;
  }
  end.proof = proof(scaled, force);
  if (end.proof.size() > 0) end.report.status = SolveStatus::Infeasible;
  return end;
}

/// Where the path stands, which is no solution; from here it would go on along `direction`.
End last_point(const ScaledProblem& scaled, const Dictionary& dictionary, Index entering,
               const Report& report, Eigen::VectorXd& direction) {
  const Index n = scaled.free.size();
  direction.setZero(n);
  End last{{}, {}, report};
  last.solution.force.setZero(n);
  if (entering >= n) direction(entering - n) = 1;
  const Eigen::VectorXd growth = dictionary.column(entering);
  for (Index i = 0; i < n; ++i) {
    const Index force = dictionary.basic(i) - n;
    if (force < 0 || force == n) continue;
    direction(force) = growth(i);
    last.solution.force(force) = std::max(dictionary.value()(i), 0.0);
  }
  last.solution.movement = scaled.free + scaled.compliance * last.solution.force;
  last.statuses = statuses_of(by_falling(last.solution.force), n);
  return last;
}

/// The state when nothing blocks the entering variable.
End ray(const ScaledProblem& scaled, const Dictionary& dictionary, Index entering, Report report) {
  report.status = SolveStatus::Ray;
  Eigen::VectorXd direction;
  End end = last_point(scaled, dictionary, entering, report, direction);
  if (scaled.symmetric) end.proof = proof(scaled, direction);
  if (end.proof.size() > 0) end.report.status = SolveStatus::Infeasible;
  return end;
}

Index limit_of(Index n, const SolverOptions& options) {
  return options.iteration_limit > 0 ? options.iteration_limit
                                     : (Index{1} << std::min<Index>(n, 20)) + 100 * n;
}

/// One path, of at most `limit` pivots.
End pivoted(const ScaledProblem& scaled, const Eigen::VectorXd& covering, Index limit) {
  const Index n = scaled.free.size();
  Report report;
  Dictionary dictionary(scaled, covering);
  if (n == 0 || (scaled.free.array() >= 0).all()) return end_of_path(scaled, dictionary, report);
  Index entering = dictionary.artificial();
  Index row = dictionary.first_row();
  while (true) {
    const Index leaving = dictionary.basic(row);
    dictionary.pivot(row, entering);
    ++report.iterations;
    if (leaving == dictionary.artificial()) return end_of_path(scaled, dictionary, report);
    entering = dictionary.partner(leaving);
    row = dictionary.blocking_row(entering);
    if (row < 0) return ray(scaled, dictionary, entering, report);
    if (report.iterations == limit) break;
  }
  report.status = SolveStatus::IterationLimit;
  Eigen::VectorXd direction;
  return last_point(scaled, dictionary, entering, report, direction);
}

/// Ones first; then entries from 1 to 2 in the order of the multiples of the golden section, which are spread
/// evenly, shifted from path to path.
Eigen::VectorXd covering_of_path(Index n, Index path) {
  const double golden = (std::sqrt(5.0) - 1) / 2;
  Eigen::VectorXd covering = Eigen::VectorXd::Ones(n);
  for (Index i = 0; i < n && path > 0; ++i) {
    const double multiple = golden * static_cast<double>(n * (path - 1) + i + 1);
    covering(i) += multiple - std::floor(multiple);
  }
  return covering;
}

ContactState state_of(const ContactProblem& problem, const ScaledProblem& scaled, End end) {
  return finished(problem, scaled, end.solution, end.statuses, std::move(end.report),
                  std::move(end.proof));
}

}  // namespace

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

ContactState lemke(const ContactProblem& problem, const SolverOptions& options) {
  if (!problem.law.pair.empty() || problem.resultant.size() > 0) {
    if (problem.resultant.size() > 0) check_problem(problem);
    const ScaledProblem scaled = equilibrate_any(problem);
    Iterate iterate = first_iterate(scaled);
    follow_pivots(scaled, options, iterate);
    return finished(problem, scaled, std::move(iterate));
  }
  const ScaledProblem scaled = equilibrate_any(problem);
  const Index n = problem.free_gap.size();
  const Index limit = limit_of(n, options);
  Index pivots = 0;
  Index length = n * n + 100 * n;
  for (Index path = 0;; ++path) {
    End end = pivoted(scaled, covering_of_path(n, path), std::min(length, limit - pivots));
    pivots = end.report.iterations += pivots;
    if (end.report.status != SolveStatus::IterationLimit || pivots >= limit)
      return state_of(problem, scaled, std::move(end));
    length *= 2;
  }
}

Solver lemke() {
  return Solver{"lemke",
                "complementary pivoting along a path, ties lexicographic; any square matrix", lemke}
      .may_fail_on({Trait::IllConditioned, Trait::Slow})
      .with_friction(Takes::Also)
      .with_rigid_modes();
}

}  // namespace signorini

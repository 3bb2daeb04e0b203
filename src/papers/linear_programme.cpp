#include "papers/linear_programme.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/active_set_system.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// The tableau B^-1 [I, -G | d] of gap - G force = d. Variables 0, ..., n - 1 are the gaps, n, ..., 2n - 1
/// the forces, and column 2n holds the values of the basis. An artificial variable is minus a gap or
/// minus a force: the amount by which that one is negative.
class Tableau {
 public:
  /// Starts from the basis that closes some pairs and no others; what is negative there turns artificial.
  Tableau(const ScaledProblem& problem, const std::vector<Index>& closed)
      : problem_(&problem), n_(problem.free.size()), rows_(n_, 2 * n_ + 1) {
    rows_ << Eigen::MatrixXd::Identity(n_, n_), -problem.compliance, problem.free;
    for (Index i = 0; i < n_; ++i) basis_.push_back(i);
    Eigen::MatrixXd B = Eigen::MatrixXd::Identity(n_, n_);
    for (const Index i : closed) {
      basis_[static_cast<std::size_t>(i)] = n_ + i;
      B.col(i) = -problem.compliance.col(i);
    }
    if (!closed.empty()) rows_ = LuFactor(B).solve_columns(rows_);
    artificial_ = (values().array() < 0).cast<double>();
    rows_ = (1 - 2 * artificial_.array()).matrix().asDiagonal() * rows_;
    first_ = basis_;
    first_artificial_ = artificial_;
    first_sum_ = artificial_sum();
  }

  // [entry]
  /// The variable whose entry lowers the sum most and whose partner is not in the basis, or -1.
  [[nodiscard]] Index entering() const {
    std::vector<bool> taken(static_cast<std::size_t>(n_), false);
    for (Index row = 0; row < n_; ++row)
      if (artificial_(row) == 0) taken[static_cast<std::size_t>(basis(row) % n_)] = true;
    const VectorXd gain = rows_.transpose() * artificial_;
    const VectorXd size = rows_.cwiseAbs().transpose() * artificial_;
    Index best = -1;
    for (Index j = 0; j < 2 * n_; ++j)
      if (!taken[static_cast<std::size_t>(j % n_)] && gain(j) > rounding() * size(j) &&
          (best < 0 || gain(j) > gain(best)))
        best = j;
    return best;
  }
  // [entry]

  /// The row whose variable reaches zero first, or -1. Of equal rows the lexicographic rule takes one.
  [[nodiscard]] Index leaving(Index column) const {
    const double tiny = rounding() * rows_.col(column).cwiseAbs().maxCoeff();
    std::vector<Index> rows;
    for (Index row = 0; row < n_; ++row)
      if (rows_(row, column) > tiny) rows.push_back(row);
    keep_smallest(rows, column, 2 * n_, 1);
    for (Index k = 0; k < n_ && rows.size() > 1; ++k)
      keep_smallest(rows, column, first_[static_cast<std::size_t>(k)],
                    1 - 2 * first_artificial_(k));
    return rows.empty() ? -1 : rows.front();
  }

  void pivot(Index row, Index column) {
    rows_.row(row) /= rows_(row, column);
    VectorXd factor = rows_.col(column);
    factor(row) = 0;
    rows_.noalias() -= factor * rows_.row(row);
    rows_.col(column).setZero();
    rows_(row, column) = 1;
    rows_.col(2 * n_) = rows_.col(2 * n_).cwiseMax(0.0);  // negative is rounding
    basis_[static_cast<std::size_t>(row)] = column;
    artificial_(row) = 0;
  }

  [[nodiscard]] double artificial_sum() const { return artificial_.dot(values().cwiseMax(0.0)); }
  [[nodiscard]] bool feasible() const { return artificial_sum() <= rounding() * first_sum_; }

  /// Pairs whose force is in the basis, the largest force first.
  [[nodiscard]] std::vector<Index> closed() const {
    std::vector<std::pair<double, Index>> forces;
    for (Index row = 0; row < n_; ++row)
      if (artificial_(row) == 0 && basis(row) >= n_)
        forces.emplace_back(-values()(row), basis(row) - n_);
    std::sort(forces.begin(), forces.end());
    std::vector<Index> pairs;
    for (const auto& force : forces) pairs.push_back(force.second);
    return pairs;
  }

  /// Forces and gaps of the basis; an artificial number is an overlap or a tension.
  [[nodiscard]] ActiveSetSolution numbers() const {
    ActiveSetSolution now;
    now.force.setZero(n_);
    now.movement.setZero(n_);
    for (Index row = 0; row < n_; ++row)
      (basis(row) < n_ ? now.movement : now.force)(basis(row) % n_) =
          (1 - 2 * artificial_(row)) * values()(row);
    return now;
  }

  [[nodiscard]] Iteration summary(double first_sum) const {
    const ActiveSetSolution now = numbers();
    Iteration entry;
    entry.active = static_cast<Index>(closed().size());
    entry.changes = static_cast<Index>(artificial_.sum());
    entry.penetration = std::max(0.0, -now.movement.cwiseQuotient(problem_->scale).minCoeff());
    entry.tension = std::max(0.0, -now.force.cwiseProduct(problem_->scale).minCoeff());
    entry.dual_energy = -now.force.dot(problem_->free + 0.5 * (problem_->compliance * now.force));
    entry.residual = artificial_sum() / first_sum;
    return entry;
  }

  /// Minus the prices of the equations if they prove that nothing solves the problem, else nothing.
  [[nodiscard]] VectorXd proof() const {
    VectorXd y = -(rows_.leftCols(n_).transpose() * artificial_);
    const double small = rounding() * y.cwiseAbs().maxCoeff();
    y = (y.array() > small).select(y, 0.0);
    const VectorXd moved = problem_->compliance * y;
    const VectorXd size = problem_->compliance.cwiseAbs() * y;
    if ((moved.cwiseAbs().array() > rounding() * size.array()).any()) return {};
    return problem_->free.dot(y) < -rounding() * problem_->free.cwiseAbs().dot(y) ? y : VectorXd();
  }

 private:
  [[nodiscard]] Index basis(Index row) const { return basis_[static_cast<std::size_t>(row)]; }
  [[nodiscard]] Eigen::MatrixXd::ConstColXpr values() const { return rows_.col(2 * n_); }
  [[nodiscard]] double rounding() const { return static_cast<double>(n_ + 1) * epsilon; }

  /// Keeps the rows whose entry in a column, times a sign, over the pivot is smallest to rounding.
  void keep_smallest(std::vector<Index>& rows, Index column, Index of, double sign) const {
    double smallest = std::numeric_limits<double>::infinity();
    double size = 0;
    const auto ratio = [&](Index row) { return sign * rows_(row, of) / rows_(row, column); };
    for (const Index row : rows) {
      smallest = std::min(smallest, ratio(row));
      size = std::max(size, std::abs(rows_(row, of)));
    }
    const auto larger = [&](Index row) {
      return ratio(row) - smallest > rounding() * size / rows_(row, column);
    };
    rows.erase(std::remove_if(rows.begin(), rows.end(), larger), rows.end());
  }

  const ScaledProblem* problem_;
  Index n_;
  Eigen::MatrixXd rows_;
  std::vector<Index> basis_;   ///< the variable of each row
  VectorXd artificial_;        ///< 1 where it is an artificial one, minus that variable; else 0
  std::vector<Index> first_;   ///< the basis at the start, whose columns order equal rows
  VectorXd first_artificial_;  ///< and its marks
  double first_sum_ = 0;
};

/// Pivots until no artificial number is left, or the rule names no pivot. \return whether the limit allows that
bool pivot_to_end(Tableau& tableau, double first_sum, Index limit, Report& report) {
  for (;; ++report.iterations) {
    const Index column = tableau.feasible() ? -1 : tableau.entering();
    const Index row = column < 0 ? -1 : tableau.leaving(column);
    if (row < 0) return true;
    if (report.iterations >= limit) return false;
    tableau.pivot(row, column);
    report.history.push_back(tableau.summary(first_sum));
  }
}

ContactState run(const ContactProblem& problem, const ScaledProblem& scaled,
                 const std::vector<Index>& start, const SolverOptions& options) {
  const Index n = scaled.free.size();
  const Index limit = options.iteration_limit > 0 ? options.iteration_limit : 100 * n + 100;
  Tableau tableau(scaled, start);
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
      tableau = Tableau(scaled, closed);
      ++report.factorisations;
      rebuilt = report.iterations;
    }
  }
  if (proof.size() > 0) proof = scaled.scale.cwiseProduct(proof);
  return finished(problem, scaled, tableau.numbers(), statuses_of(tableau.closed(), n),
                  std::move(report), std::move(proof));
}

}  // namespace

ContactState linear_programme(const ContactProblem& problem, const SolverOptions& options) {
  check_plain(problem, "linear_programme");
  return run(problem, equilibrate(problem), {}, options);
}

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
                         states.empty() ? std::vector<Index>() : states.back().active, options));
    if (states.back().report.status != SolveStatus::Solved) break;
  }
  return states;
}

}  // namespace signorini

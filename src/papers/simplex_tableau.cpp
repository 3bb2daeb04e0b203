// # A tableau that closes pairs
//
// Gaps w and forces \f$ \lambda \f$ obey \f$ w - G\lambda = d \f$ and are not negative: the
// constraints of a linear programme. A *basis* holds n of the 2n numbers, the others are zero. If
// all gaps are in the basis, \f$ w = d \f$, and pairs that overlap have negative ones. Each of
// those is replaced by an *artificial* variable, its amount, and the simplex method exchanges one
// variable at a time until the sum of these amounts is zero.
//
// For \f$ G = \begin{pmatrix} 2 & 1 \\ 1 & 2 \end{pmatrix} \f$ and \f$ d = (-7, -5) \f$ the
// overlaps are 7 and 5, with the sum 12. If \f$ \lambda_1 \f$ enters, both become smaller; the
// first vanishes at \f$ \lambda_1 = 7/2 \f$, where the second is 3/2. Then \f$ \lambda_2 \f$
// enters: it lowers the second by 3/2 per unit, so that this one vanishes at \f$ \lambda_2 = 1 \f$,
// where \f$ \lambda_1 = 3 \f$. Two pivots, and the problem is solved.
//
// A linear programme knows nothing of \f$ \lambda_i w_i = 0 \f$. A rule adds it: a variable may
// enter only if its partner is not in the basis.

#include "papers/simplex_tableau.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "signorini/core/dense.hpp"

namespace signorini {

using Eigen::Index, Eigen::VectorXd;

// A start with closed pairs is a basis with their forces in the place of their gaps. What is
// negative then, a gap or a force, is artificial at first.
SimplexTableau::SimplexTableau(const ScaledProblem& problem, const std::vector<Index>& closed)
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
// The variable whose entry lowers the sum most and whose partner is not in the basis, or -1.
Index SimplexTableau::entering() const {
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

// The variable that enters grows until another one reaches zero. Several may do so at once. Then a
// fixed order of columns decides, the lexicographic rule, with which no basis comes back.
Index SimplexTableau::leaving(Index column) const {
  const double tiny = rounding() * rows_.col(column).cwiseAbs().maxCoeff();
  std::vector<Index> rows;
  for (Index row = 0; row < n_; ++row)
    if (rows_(row, column) > tiny) rows.push_back(row);
  keep_smallest(rows, column, 2 * n_, 1);
  for (Index k = 0; k < n_ && rows.size() > 1; ++k)
    keep_smallest(rows, column, first_[static_cast<std::size_t>(k)], 1 - 2 * first_artificial_(k));
  return rows.empty() ? -1 : rows.front();
}

// One step of Gauss and Jordan: the new variable gets a column of the unit matrix. Every entry of
// the tableau changes, which is what this method costs.
// Values are never negative in exact arithmetic, because the row was the first to reach zero. So a
// negative one is rounding, and is set to zero.
void SimplexTableau::pivot(Index row, Index column) {
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

// What the basis means for contact: pairs whose force is in it are closed.
// Those with a large force come first: if some depend on others, the large ones are kept.
std::vector<Index> SimplexTableau::closed() const {
  std::vector<std::pair<double, Index>> forces;
  for (Index row = 0; row < n_; ++row)
    if (artificial_(row) == 0 && basis(row) >= n_)
      forces.emplace_back(-values()(row), basis(row) - n_);
  std::sort(forces.begin(), forces.end());
  std::vector<Index> pairs;
  for (const auto& force : forces) pairs.push_back(force.second);
  return pairs;
}

// The same in numbers. While artificial variables are left, some of these gaps or forces are
// negative.
ActiveSetSolution SimplexTableau::numbers() const {
  ActiveSetSolution now;
  now.force.setZero(n_);
  now.movement.setZero(n_);
  for (Index row = 0; row < n_; ++row)
    (basis(row) < n_ ? now.movement : now.force)(basis(row) % n_) =
        (1 - 2 * artificial_(row)) * values()(row);
  return now;
}

// The sum that the method makes small is its residual.
Iteration SimplexTableau::summary(double first_sum) const {
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

// If no exchange is allowed and the sum is not zero, the prices y of the equations may prove that
// nothing solves the problem: if \f$ y \ge 0 \f$, \f$ Gy = 0 \f$ and \f$ d^T y < 0 \f$, the
// weighted gap \f$ y^T(d + G\lambda) = d^T y \f$ is negative for all forces.
VectorXd SimplexTableau::proof() const {
  VectorXd y = -(rows_.leftCols(n_).transpose() * artificial_);
  const double small = rounding() * y.cwiseAbs().maxCoeff();
  y = (y.array() > small).select(y, 0.0);
  const VectorXd moved = problem_->compliance * y;
  const VectorXd size = problem_->compliance.cwiseAbs() * y;
  if ((moved.cwiseAbs().array() > rounding() * size.array()).any()) return {};
  return problem_->free.dot(y) < -rounding() * problem_->free.cwiseAbs().dot(y) ? y : VectorXd();
}

// Ratios that differ by rounding count as equal.
// In a problem with a symmetry two pairs reach zero at the same time, and rounding must not say
// which was first.
void SimplexTableau::keep_smallest(std::vector<Index>& rows, Index column, Index of,
                                   double sign) const {
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

}  // namespace signorini

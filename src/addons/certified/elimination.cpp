#include "addons/certified/elimination.hpp"

#include <algorithm>
#include <cmath>

#include "signorini/core/dense.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A column that changes until it is a pivot or nothing.
struct SparseColumn {
  SparseEntries left;                           ///< by rising rows
  double terms = 0;                             ///< the largest that made an entry
  std::vector<std::pair<Index, double>> taken;  ///< multiples of pivot columns, in order
  bool pivoted = false;

  /// Takes a multiple of another column away, so that nothing is left in one row. \return rows of new entries
  std::vector<Index> take(const SparseColumn& other, double factor, Index row) {
    std::vector<Index> filled;
    SparseEntries sum;
    sum.reserve(left.size() + other.left.size());
    auto mine = left.begin();
    for (const auto& [its_row, its_value] : other.left) {
      while (mine != left.end() && mine->first < its_row) sum.push_back(*mine++);
      const bool had = mine != left.end() && mine->first == its_row;
      const double before = had ? (mine++)->second : 0;
      if (!had) filled.push_back(its_row);
      if (its_row != row) sum.emplace_back(its_row, before - factor * its_value);
    }
    sum.insert(sum.end(), mine, left.end());
    left = std::move(sum);
    terms = std::max(terms, std::abs(factor) * other.terms);
    return filled;
  }
};

double value(const SparseColumn& column, Index row) {
  const auto found = std::lower_bound(column.left.begin(), column.left.end(), row,
                                      [](const auto& entry, Index r) { return entry.first < r; });
  return found != column.left.end() && found->first == row ? found->second : 0;
}

class Elimination {
 public:
  Elimination(const std::vector<SparseEntries>& columns, Index rows, double share);

  [[nodiscard]] std::vector<SparseEntries> combinations();

 private:
  void measure(Index column);
  void eliminate(Index column);
  [[nodiscard]] SparseEntries combination(Index column) const;

  double share_;
  std::vector<SparseColumn> columns_;
  std::vector<std::vector<Index>> of_row_;         ///< columns that have an entry, or had one
  std::vector<std::pair<double, Index>> largest_;  ///< entry of each column, and its row
  std::vector<Index> pivots_;                      ///< columns, in order
};

Elimination::Elimination(const std::vector<SparseEntries>& columns, Index rows, double share)
    : share_(share), columns_(columns.size()), of_row_(at(rows)), largest_(columns.size()) {
  for (std::size_t j = 0; j < columns.size(); ++j) {
    SparseEntries sorted = columns[j];
    std::sort(sorted.begin(), sorted.end());
    SparseColumn& column = columns_[j];
    for (const auto& [row, value] : sorted) {
      if (column.left.empty() || column.left.back().first != row) {
        column.left.emplace_back(row, 0);
        of_row_[at(row)].push_back(static_cast<Index>(j));
      }
      column.left.back().second += value;
      column.terms = std::max(column.terms, std::abs(value));
    }
    measure(static_cast<Index>(j));
  }
}

void Elimination::measure(Index column) {
  std::pair<double, Index> most{0, -1};
  for (const auto& [row, value] : columns_[at(column)].left)
    if (std::abs(value) > most.first) most = {std::abs(value), row};
  const bool nothing = most.first <= share_ * columns_[at(column)].terms;
  largest_[at(column)] = nothing ? std::pair(0.0, Index{-1}) : most;
}

void Elimination::eliminate(Index column) {
  SparseColumn& pivot = columns_[at(column)];
  const Index row = largest_[at(column)].second;
  const double divisor = value(pivot, row);
  pivot.pivoted = true;
  largest_[at(column)] = {0, -1};
  const Index step = static_cast<Index>(pivots_.size());
  pivots_.push_back(column);
  for (const Index j : of_row_[at(row)]) {
    SparseColumn& other = columns_[at(j)];
    const double factor = other.pivoted ? 0 : value(other, row) / divisor;
    if (factor == 0) continue;
    for (const Index filled : other.take(pivot, factor, row)) of_row_[at(filled)].push_back(j);
    other.taken.emplace_back(step, factor);
    measure(j);
  }
}

std::vector<SparseEntries> Elimination::combinations() {
  while (true) {
    const auto next =
        std::max_element(largest_.begin(), largest_.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
    if (next == largest_.end() || next->second < 0) break;
    eliminate(next - largest_.begin());
  }
  std::vector<SparseEntries> all;
  for (std::size_t j = 0; j < columns_.size(); ++j)
    if (!columns_[j].pivoted) all.push_back(combination(static_cast<Index>(j)));
  return all;
}

/// What is left of a column is the column less multiples of what was left of the pivots, each of which is a column less
/// multiples of those before.
SparseEntries Elimination::combination(Index column) const {
  VectorXd factor = VectorXd::Zero(static_cast<Index>(pivots_.size()));
  for (const auto& [step, value] : columns_[at(column)].taken) factor(step) = value;
  for (Index step = factor.size() - 1; step >= 0; --step)
    if (factor(step) != 0)
      for (const auto& [before, value] : columns_[at(pivots_[at(step)])].taken)
        factor(before) -= factor(step) * value;
  const double most = factor.size() > 0 ? std::max(1.0, factor.cwiseAbs().maxCoeff()) : 1;
  SparseEntries result{{column, 1 / most}};
  for (Index step = 0; step < factor.size(); ++step)
    if (std::abs(factor(step)) > share_ * most)
      result.emplace_back(pivots_[at(step)], -factor(step) / most);
  return result;
}

/// Whether columns that fill most of a matrix are independent beyond doubt: if E^T E, of columns of length 1, is positive definite
/// less what rounding can be. Elimination of such columns takes longer than to solve their problem.
bool surely_independent(const std::vector<SparseEntries>& columns, Index rows) {
  const Index n = static_cast<Index>(columns.size());
  std::size_t entries = 0;
  for (const SparseEntries& column : columns) entries += column.size();
  if (n > rows || 2 * entries < at(n) * at(rows)) return false;
  MatrixXd E = MatrixXd::Zero(rows, n);
  for (Index j = 0; j < n; ++j)
    for (const auto& [row, value] : columns[at(j)]) E(row, j) += value;
  for (auto column : E.colwise()) column.normalize();
  MatrixXd products = E.transpose() * E;
  products.diagonal().array() -= static_cast<double>(n) * static_cast<double>(n + rows) * epsilon;
  return CholeskyFactor(products).positive();
}

}  // namespace

std::vector<SparseEntries> null_combinations(const std::vector<SparseEntries>& columns, Index rows,
                                             double share) {
  if (surely_independent(columns, rows)) return {};
  return Elimination(columns, rows, share).combinations();
}

}  // namespace signorini

#include "signorini/closing/elimination.hpp"

#include <algorithm>
#include <cmath>

#include "signorini/core/index.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// What is left of an entry, and the sum of its terms' sizes.
struct Entry {
  Index row;
  double value;
  double size;
};

/// A column that changes until it is a pivot or nothing.
struct Column {
  std::vector<Entry> left;                      ///< by rising rows
  std::vector<std::pair<Index, double>> taken;  ///< multiples of pivot columns, in order
  bool pivoted = false;

  /// The largest entry, or null if there is none beyond a share of the terms.
  [[nodiscard]] const Entry* largest(double share) const {
    double terms = 0;
    const Entry* most = nullptr;
    for (const Entry& entry : left) {
      terms = std::max(terms, entry.size);
      if (most == nullptr || std::abs(entry.value) > std::abs(most->value)) most = &entry;
    }
    return most != nullptr && std::abs(most->value) > share * terms ? most : nullptr;
  }

  /// Takes a multiple of another column away, so that nothing is left in one row.
  void take(const Column& other, double factor, Index row) {
    std::vector<Entry> sum;
    sum.reserve(left.size() + other.left.size());
    auto mine = left.begin();
    for (const Entry& entry : other.left) {
      while (mine != left.end() && mine->row < entry.row) sum.push_back(*mine++);
      Entry now{entry.row, -factor * entry.value, std::abs(factor) * entry.size};
      if (mine != left.end() && mine->row == entry.row) {
        now.value += mine->value;
        now.size += (mine++)->size;
      }
      if (entry.row != row) sum.push_back(now);
    }
    sum.insert(sum.end(), mine, left.end());
    left = std::move(sum);
  }
};

double value(const Column& column, Index row) {
  const auto found = std::lower_bound(column.left.begin(), column.left.end(), row,
                                      [](const Entry& entry, Index r) { return entry.row < r; });
  return found != column.left.end() && found->row == row ? found->value : 0;
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
  std::vector<Column> columns_;
  std::vector<std::vector<Index>> of_row_;         ///< columns that have an entry, or had one
  std::vector<std::pair<double, Index>> largest_;  ///< entry of each column, and its row
  std::vector<Index> pivots_;                      ///< columns, in order
};

Elimination::Elimination(const std::vector<SparseEntries>& columns, Index rows, double share)
    : share_(share), columns_(columns.size()), of_row_(at(rows)), largest_(columns.size()) {
  for (std::size_t j = 0; j < columns.size(); ++j) {
    SparseEntries sorted = columns[j];
    std::sort(sorted.begin(), sorted.end());
    std::vector<Entry>& left = columns_[j].left;
    for (const auto& [row, value] : sorted) {
      if (left.empty() || left.back().row != row) {
        left.push_back({row, 0, 0});
        of_row_[at(row)].push_back(static_cast<Index>(j));
      }
      left.back().value += value;
      left.back().size += std::abs(value);
    }
    measure(static_cast<Index>(j));
  }
}

void Elimination::measure(Index column) {
  const Entry* most = columns_[at(column)].largest(share_);
  largest_[at(column)] =
      most == nullptr ? std::pair(0.0, Index{-1}) : std::pair(std::abs(most->value), most->row);
}

void Elimination::eliminate(Index column) {
  Column& pivot = columns_[at(column)];
  const Index row = largest_[at(column)].second;
  const double divisor = value(pivot, row);
  pivot.pivoted = true;
  largest_[at(column)] = {0, -1};
  const Index step = static_cast<Index>(pivots_.size());
  pivots_.push_back(column);
  for (const Index j : of_row_[at(row)]) {
    Column& other = columns_[at(j)];
    const double factor = other.pivoted ? 0 : value(other, row) / divisor;
    if (factor == 0) continue;
    for (const Entry& entry : pivot.left)
      if (value(other, entry.row) == 0) of_row_[at(entry.row)].push_back(j);  // a new entry
    other.take(pivot, factor, row);
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

}  // namespace

std::vector<SparseEntries> null_combinations(const std::vector<SparseEntries>& columns, Index rows,
                                             double share) {
  return Elimination(columns, rows, share).combinations();
}

}  // namespace signorini

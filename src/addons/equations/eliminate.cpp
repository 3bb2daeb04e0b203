#include "addons/equations/eliminate.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

/// Beside the largest entry that was added up, a row whose entries are all less than this says nothing new.
constexpr double nothing = 1e-12;

/// Beside the same, an entry of a row that is no more than this is what rounding leaves where terms cancel, and is left out. That
/// is an error of this size in the row: it must be far below what a certificate lets pass.
constexpr double cancelled = 8 * epsilon;

/// Beside the largest entry of a row, less than this changes no digit of what the row gives: the entries of mortar rows on
/// sides with middle nodes die away like this, and would join all nodes of the side.
constexpr double faint = 0x1p-64;

using Sum = std::map<Index, double>;

void add(double factor, const Sum& from, Sum& to) {
  for (const auto& [place, value] : from) to[place] += factor * value;
}

double largest_of(const Sum& sum) {
  double most = 0;
  for (const auto& entry : sum) most = std::max(most, std::abs(entry.second));
  return most;
}

/// Leaves entries out. \param least  up to this they are nothing
void drop(double least, Sum& sum) {
  for (auto entry = sum.begin(); entry != sum.end();)
    entry = std::abs(entry->second) <= least ? sum.erase(entry) : std::next(entry);
}

/// An equation: terms of unknowns on the left, of the rows that were given on the right. Solved for an unknown, that stands alone.
struct Row {
  Index unknown = -1;
  Sum terms;
  Sum right;
};

class Elimination {
 public:
  explicit Elimination(Index unknowns) : row_of_(at(unknowns), -1) {}

  /// Puts what is known into an equation. \return the largest entry of what was added up
  double reduce(Row& row) const {
    double most = largest_of(row.terms);
    const Sum given = row.terms;
    for (const auto& [unknown, value] : given) {
      if (row_of_[at(unknown)] < 0) continue;
      const Row& known = rows[at(row_of_[at(unknown)])];
      row.terms.erase(unknown);
      for (const auto& term : known.terms) most = std::max(most, std::abs(value * term.second));
      add(value, known.terms, row.terms);
      add(-value, known.right, row.right);
    }
    return most;
  }

  /// Solves an equation for an unknown, and puts that into those before it.
  void solve(Row row, Index unknown) {
    const double pivot = row.terms.at(unknown);
    row.terms.erase(unknown);
    for (auto& term : row.terms) term.second /= -pivot;
    for (auto& term : row.right) term.second /= pivot;
    drop(faint * largest_of(row.terms), row.terms);
    row.unknown = unknown;
    const Index number = static_cast<Index>(rows.size());
    for (const Index other : users_[unknown]) put(row, rows[at(other)], other);
    users_.erase(unknown);
    for (const auto& term : row.terms) users_[term.first].insert(number);
    row_of_[at(unknown)] = number;
    rows.push_back(std::move(row));
  }

  std::vector<Row> rows;

 private:
  /// Puts a solved row into one before it that uses its unknown.
  void put(const Row& solved, Row& into, Index number) {
    const auto found = into.terms.find(solved.unknown);
    if (found == into.terms.end()) return;
    const double factor = found->second;
    into.terms.erase(found);
    add(factor, solved.terms, into.terms);
    add(factor, solved.right, into.right);
    drop(faint * largest_of(into.terms), into.terms);
    for (const auto& term : solved.terms) users_[term.first].insert(number);
  }

  std::vector<Index> row_of_;                // of each unknown; -1: it is not solved for
  std::map<Index, std::set<Index>> users_;  // rows that may have an unknown, and some that had
};

Index pivot_of(const Sum& terms, Index own) {
  const double most = largest_of(terms);
  const auto named = terms.find(own);
  if (named != terms.end() && std::abs(named->second) >= 0.1 * most) return own;
  Index best = -1;
  for (const auto& [unknown, value] : terms)
    if (best < 0 && std::abs(value) >= (1 - nothing) * most) best = unknown;
  return best;
}

NodalRows matrix(const std::vector<Row>& rows, Sum Row::*part, Index columns) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (const auto& [column, value] : rows[k].*part)
      entries.emplace_back(static_cast<int>(k), static_cast<int>(column), value);
  NodalRows all(static_cast<Index>(rows.size()), columns);
  all.setFromTriplets(entries.begin(), entries.end());
  return all;
}

}  // namespace

NodalRows free_columns(const NodalRows& rows, const Unknowns& unknowns) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Index row = 0; row < rows.rows(); ++row)
    for (NodalRows::InnerIterator it(rows, row); it; ++it)
      if (const Index unknown = unknowns.number(it.col() / 2, it.col() % 2); unknown >= 0)
        entries.emplace_back(static_cast<int>(row), static_cast<int>(unknown), it.value());
  NodalRows free(rows.rows(), unknowns.count);
  free.setFromTriplets(entries.begin(), entries.end());
  return free;
}

Eliminated eliminate(const NodalRows& rows, const VectorXd& right, const VectorXd& rounding,
                     const std::vector<Index>& own, const std::vector<Index>& which) {
  Elimination solved(rows.cols());
  Eliminated all;
  for (const Index k : which) {
    Row row;
    row.right[k] = 1;
    for (NodalRows::InnerIterator entry(rows, k); entry; ++entry)
      if (entry.value() != 0) row.terms[entry.col()] = entry.value();
    const double most = solved.reduce(row);
    if (largest_of(row.terms) > nothing * most) {
      drop(cancelled * most, row.terms);
      solved.solve(row, pivot_of(row.terms, own[at(k)]));
      continue;
    }
    double left = 0;
    double allowed = 0;
    // Factors that cancel leave a rounding of the largest, a little more with every row.
    const double noise =
        cancelled * static_cast<double>(solved.rows.size() + 1) * largest_of(row.right);
    for (const auto& [from, factor] : row.right) {
      left += factor * right(from);
      allowed += std::abs(factor) * (rounding(from) + nothing * std::abs(right(from))) +
                 noise * std::abs(right(from));
    }
    if (std::abs(left) > allowed && all.contradicting.empty()) {
      all.apart = std::abs(left);
      row.right.erase(k);
      const double weight = largest_of(row.right);
      for (const auto& [from, factor] : row.right)
        if (all.other < 0 && weight > cancelled && std::abs(factor) == weight) all.other = from;
    }
    (std::abs(left) <= allowed ? all.repeated : all.contradicting).push_back(k);
  }
  for (const Row& row : solved.rows) all.unknown.push_back(row.unknown);
  all.by = matrix(solved.rows, &Row::terms, rows.cols());
  all.right = matrix(solved.rows, &Row::right, rows.rows());
  return all;
}

}  // namespace signorini

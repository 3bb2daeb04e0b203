#include "addons/frontal/fronts.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Matrix = Eigen::SparseMatrix<double>;

/// Whether a tree has each of n unknowns once, and separators that follow each other.
bool is_of(const SeparatorTree& tree, Index n) {
  std::vector<bool> seen(static_cast<std::size_t>(n), false);
  for (const int unknown : tree.order) {
    if (unknown < 0 || unknown >= n || seen[at(unknown)]) return false;
    seen[at(unknown)] = true;
  }
  Index next = 0;
  for (std::size_t s = 0; s < tree.separators.size(); ++s) {
    const Separator& separator = tree.separators[s];
    if (separator.first != next || separator.own < 0) return false;
    for (const int below : separator.below)
      if (below < -1 || below >= static_cast<int>(s)) return false;
    next += separator.own;
  }
  return next == n && static_cast<Index>(tree.order.size()) == n;
}

/// A subtree with at most this share of all operations is one part. Threads that find no part left wait for the others: of 16
/// threads each for at most a quarter of its own work.
constexpr double largest_share = 1.0 / 64;
/// And one with so few operations, which are done while a thread begins.
constexpr double smallest_part = 1e6;

/// Parts of a tree, from the sizes of the fronts alone.
std::vector<TreePart> parts_of(const Fronts& fronts) {
  const std::size_t count = fronts.all.size();
  std::vector<double> work(count);    // of each front and all below it
  std::vector<int> first(count);      // the first front there
  std::vector<int> above(count, -1);  // the front above each
  for (std::size_t k = 0; k < count; ++k) {
    const Front& front = fronts.all[k];
    work[k] = elimination_operations(front.own(), front.rim());
    first[k] = static_cast<int>(k);
    for (const int below : front.separator.below) {
      if (below < 0) continue;
      work[k] += work[at(below)];
      first[k] = std::min(first[k], first[at(below)]);
      above[at(below)] = static_cast<int>(k);
    }
  }
  const double limit = std::max(smallest_part, largest_share * fronts.operations());
  std::vector<TreePart> parts;
  std::vector<int> part_of(count, -1);  // that ends with a front
  for (std::size_t k = 0; k < count; ++k) {
    const bool whole = work[k] <= limit;
    if (whole && above[k] >= 0 && work[at(above[k])] <= limit) continue;
    part_of[k] = static_cast<int>(parts.size());
    parts.push_back({whole ? first[k] : static_cast<int>(k), static_cast<int>(k) + 1, -1, {}});
    if (whole) continue;
    for (const int below : fronts.all[k].separator.below)
      if (below >= 0) parts.back().below.push_back(part_of[at(below)]);
    for (const int below : parts.back().below) parts[at(below)].above = part_of[k];
  }
  return parts;
}

}  // namespace

Fronts fronts_of(const Matrix& matrix, const SeparatorTree& tree) {
  require_argument(matrix.rows() == matrix.cols() && matrix.isCompressed(),
                   "fronts_of: need a square matrix after makeCompressed(), got ", matrix.rows(),
                   " x ", matrix.cols());
  require_argument(is_of(tree, matrix.cols()), "fronts_of: need a tree with each of the ",
                   matrix.cols(), " unknowns once, got one of ", tree.order.size());
  Fronts fronts;
  fronts.order = tree.order;
  fronts.place.resize(tree.order.size());
  for (std::size_t k = 0; k < tree.order.size(); ++k)
    fronts.place[at(tree.order[k])] = static_cast<int>(k);
  std::vector<int> seen(tree.order.size(), -1);  // the last front that a place is in
  for (const Separator& separator : tree.separators) {
    const int number = static_cast<int>(fronts.all.size());
    Front front{separator, {}, fronts.entries};
    const int end = separator.first + separator.own;
    const auto take = [&](int place) {
      if (place < end || seen[at(place)] == number) return;
      seen[at(place)] = number;
      front.boundary.push_back(place);
    };
    for (int k = separator.first; k < end; ++k)
      for (Matrix::InnerIterator entry(matrix, tree.order[at(k)]); entry; ++entry)
        take(fronts.place[at(static_cast<int>(entry.row()))]);
    for (const int below : separator.below)
      if (below >= 0)
        for (const int place : fronts.front(below).boundary) take(place);
    std::sort(front.boundary.begin(), front.boundary.end());
    fronts.entries += front.rows() * front.own();
    fronts.tallest = std::max(fronts.tallest, front.rows());
    fronts.all.push_back(std::move(front));
  }
  fronts.parts = parts_of(fronts);
  return fronts;
}

/// What a separator parts, with the separator itself, is one run of the order. An entry of an unknown is with one of its own
/// run, or with a later one, whose run then has it.
bool keeps_apart(const SeparatorTree& tree, const Matrix& matrix) {
  const std::size_t n = tree.order.size();
  if (static_cast<std::size_t>(matrix.cols()) != n) return false;
  std::vector<int> place(n);
  std::vector<int> begin(n);  // of the run of the separator that eliminates what is at a place
  std::vector<int> run;       // its begin, of each separator
  for (const Separator& separator : tree.separators) {
    run.push_back(separator.first);
    for (const int below : separator.below)
      if (below >= 0) run.back() = std::min(run.back(), run[at(below)]);
    for (int k = separator.first; k < separator.first + separator.own; ++k) {
      place[at(tree.order[at(k)])] = k;
      begin[at(k)] = run.back();
    }
  }
  for (Index column = 0; column < matrix.cols(); ++column) {
    const int to = place[at(static_cast<int>(column))];
    for (Matrix::InnerIterator entry(matrix, column); entry; ++entry) {
      const int from = place[at(static_cast<int>(entry.row()))];
      if (from < to && from < begin[at(to)]) return false;
    }
  }
  return true;
}

int Fronts::part_below(const TreePart& part, int front) const {
  return *std::find_if(part.below.begin(), part.below.end(),
                       [&](int below) { return parts[at(below)].end == front + 1; });
}

int Fronts::front_at(int position) const {
  const auto found = std::upper_bound(
      all.begin(), all.end(), position,
      [](int p, const Front& front) { return p < front.separator.first + front.separator.own; });
  return static_cast<int>(found - all.begin());
}

Index Fronts::nonzeros() const {
  Index sum = 0;
  for (const Front& front : all)
    sum += front.own() * (front.own() + 1) / 2 + front.own() * front.rim();
  return sum;
}

double Fronts::operations() const {
  double sum = 0;
  for (const Front& front : all) sum += elimination_operations(front.own(), front.rim());
  return sum;
}

double Fronts::solve_operations() const {
  double sum = 0;
  for (const Front& front : all) sum += front.solve_operations();
  return sum;
}

StackPlan Fronts::stack(std::vector<Index> sizes) const {
  std::vector<std::array<int, 2>> below;
  for (const Front& front : all) below.push_back(front.separator.below);
  return {below, std::move(sizes)};
}

StackPlan Fronts::stack(const TreePart& part, const std::vector<Index>& sizes) const {
  std::vector<std::array<int, 2>> below;
  for (int number = part.first; number + 1 < part.end; ++number) {
    below.push_back(front(number).separator.below);
    for (int& one : below.back())
      if (one >= 0) one -= part.first;
  }
  const auto begin = sizes.begin() + part.first;
  return {below, std::vector<Index>(begin, begin + static_cast<std::ptrdiff_t>(below.size()))};
}

std::vector<Index> Fronts::update_sizes() const {
  std::vector<Index> sizes;
  for (const Front& front : all) sizes.push_back(front.rim() * front.rim());
  return sizes;
}

StackPlan Fronts::update_stack() const { return stack(update_sizes()); }

RowPaths row_paths(const Fronts& fronts, const Matrix& A) {
  require_argument(A.cols() == fronts.size(), "row_paths: A must have ", fronts.size(),
                   " columns (one per unknown), got ", A.cols());
  RowPaths paths;
  paths.rows.resize(fronts.all.size());
  std::vector<int> seen(static_cast<std::size_t>(A.rows()), -1);
  std::vector<Index> sizes;
  for (int number = 0; number < static_cast<int>(fronts.all.size()); ++number) {
    const Front& front = fronts.front(number);
    std::vector<int>& rows = paths.rows[at(number)];
    const auto take = [&](int row) {
      if (std::exchange(seen[at(row)], number) != number) rows.push_back(row);
    };
    for (int k = 0; k < front.separator.own; ++k)
      for (Matrix::InnerIterator entry(A, fronts.order[at(front.separator.first + k)]); entry;
           ++entry)
        take(static_cast<int>(entry.row()));
    for (const int below : front.separator.below)
      if (below >= 0 &&
          fronts.front(below).rim() > 0)  // a front without boundary is joined to none
        std::for_each(paths.rows[at(below)].begin(), paths.rows[at(below)].end(), take);
    std::sort(rows.begin(), rows.end());
    const Index count = static_cast<Index>(rows.size());
    sizes.push_back(front.rim() * count);
    paths.most_numbers = std::max(paths.most_numbers, front.rows() * count);
    paths.most_rows = std::max(paths.most_rows, count);
    paths.operations += carrying_operations(front.own(), front.rim(), count);
  }
  paths.stack = fronts.stack(std::move(sizes));
  return paths;
}

long long RowPaths::bytes() const {
  return static_cast<long long>(sizeof(double)) *
         (stack.most() + most_numbers + most_rows * most_rows);
}

double elimination_operations(Index own, Index rim) {
  // The k-th unknown is a root, `below` divisions and a triangle of `below` rows: below (below + 2).
  const auto sum_to = [](double most) { return most * (most + 1) * (2 * most + 7) / 6; };
  return own == 0
             ? 0
             : sum_to(static_cast<double>(own + rim - 1)) - sum_to(static_cast<double>(rim - 1));
}

double carrying_operations(Index own, Index rim, Index rows) {
  return static_cast<double>(rows) * static_cast<double>(own * (own + 2 * rim + rows + 1));
}

}  // namespace signorini

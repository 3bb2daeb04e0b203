#include "signorini/elasticity/ordering.hpp"

#include <Eigen/OrderingMethods>
#include <algorithm>

#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Matrix = Eigen::SparseMatrix<double>;

/// One flag per unknown: whether it must come last.
std::vector<char> marked(Index n, const std::vector<Index>& last) {
  std::vector<char> is_last(static_cast<std::size_t>(n), 0);
  for (const Index unknown : last) {
    require(unknown >= 0 && unknown < n && is_last[static_cast<std::size_t>(unknown)] == 0,
            "elimination order: the unknowns that come last must be distinct and below ", n,
            ", got ", unknown);
    is_last[static_cast<std::size_t>(unknown)] = 1;
  }
  return is_last;
}

/// Keeps the order but moves the marked unknowns behind all others.
EliminationOrder moved_last(EliminationOrder order, const std::vector<char>& is_last) {
  std::stable_partition(order.begin(), order.end(), [&](int unknown) {
    return is_last[static_cast<std::size_t>(unknown)] == 0;
  });
  return order;
}

/// Neighbouring unknowns with equal columns, taken as one: a graph of half the size.
struct Groups {
  std::vector<int> first;  // first unknown of every group, and one entry more at the end
  std::vector<int>
      start;  // neighbours of group g: neighbour[start[g]] ... neighbour[start[g + 1] - 1]
  std::vector<int> neighbour;
};

Groups grouped(const Matrix& K) {
  const int* start = K.outerIndexPtr();
  const int* rows = K.innerIndexPtr();
  const auto same = [&](Index a, Index b) {
    return start[a + 1] - start[a] == start[b + 1] - start[b] &&
           std::equal(rows + start[a], rows + start[a + 1], rows + start[b]);
  };
  Groups groups;
  std::vector<int> group_of(static_cast<std::size_t>(K.cols()));
  for (Index k = 0; k < K.cols(); ++k) {
    if (k == 0 || !same(k - 1, k)) groups.first.push_back(static_cast<int>(k));
    group_of[static_cast<std::size_t>(k)] = static_cast<int>(groups.first.size()) - 1;
  }
  for (const int k : groups.first) {
    groups.start.push_back(static_cast<int>(groups.neighbour.size()));
    int previous = -1;  // rows of a column increase, so their groups do too
    for (Matrix::InnerIterator entry(K, k); entry; ++entry) {
      const int group = group_of[static_cast<std::size_t>(entry.row())];
      if (group != previous) groups.neighbour.push_back(group);
      previous = group;
    }
  }
  groups.start.push_back(static_cast<int>(groups.neighbour.size()));
  groups.first.push_back(static_cast<int>(K.cols()));
  return groups;
}

/// Dissects ranges of `order_` in place.
class Dissection {
 public:
  Dissection(const Groups& groups, const NodeArray& positions)
      : groups_(groups),
        positions_(positions),
        order_(groups.first.size() - 1),
        half_(order_.size(), 0) {
    for (std::size_t g = 0; g < order_.size(); ++g) order_[g] = static_cast<int>(g);
    dissect(order_.begin(), order_.end());
  }
  [[nodiscard]] const std::vector<int>& order() const { return order_; }

 private:
  using Range = std::vector<int>::iterator;

  [[nodiscard]] double coordinate(int group, int axis) const {
    return positions_(groups_.first[static_cast<std::size_t>(group)], axis);
  }
  [[nodiscard]] int longer_axis(Range begin, Range end) const {
    double extent[2];
    for (int axis = 0; axis < 2; ++axis) {
      const auto [low, high] = std::minmax_element(
          begin, end, [&](int a, int b) { return coordinate(a, axis) < coordinate(b, axis); });
      extent[axis] = coordinate(*high, axis) - coordinate(*low, axis);
    }
    return extent[0] >= extent[1] ? 0 : 1;
  }
  [[nodiscard]] bool touches(int group, int half) const {
    for (int k = groups_.start[static_cast<std::size_t>(group)];
         k < groups_.start[static_cast<std::size_t>(group) + 1]; ++k)
      if (half_[static_cast<std::size_t>(groups_.neighbour[static_cast<std::size_t>(k)])] == half)
        return true;
    return false;
  }

  void dissect(Range begin, Range end) {
    constexpr std::ptrdiff_t leaf = 8;  // below it, nothing is gained
    if (end - begin <= leaf) return;
    const int axis = longer_axis(begin, end);
    const auto before = [&](int a, int b) {
      const double xa = coordinate(a, axis);
      const double xb = coordinate(b, axis);
      return xa < xb || (xa == xb && a < b);
    };
    const Range middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end, before);
    const double cut = coordinate(*middle, axis);
    // Whole columns of nodes stay on one side of the cut.
    const Range right =
        std::partition(begin, end, [&](int g) { return coordinate(g, axis) < cut; });
    if (right == begin) return;
    const int mark = ++marks_;
    for (Range g = begin; g != right; ++g) half_[static_cast<std::size_t>(*g)] = mark;
    const Range joint = std::partition(right, end, [&](int g) { return !touches(g, mark); });
    std::sort(begin, right);
    std::sort(right, joint);
    std::sort(joint, end);
    dissect(begin, right);
    dissect(right, joint);
  }

  const Groups& groups_;
  const NodeArray& positions_;
  std::vector<int> order_;
  std::vector<int> half_;
  int marks_ = 0;
};

}  // namespace

EliminationOrder nested_dissection(const Matrix& matrix, const NodeArray& positions,
                                   const std::vector<Index>& last) {
  require(matrix.rows() == matrix.cols() && positions.rows() == matrix.cols(),
          "nested_dissection: need one position per unknown of a square matrix, got ",
          positions.rows(), " positions for ", matrix.rows(), " x ", matrix.cols());
  const std::vector<char> is_last = marked(matrix.cols(), last);
  const Groups groups = grouped(matrix);
  EliminationOrder order;
  order.reserve(static_cast<std::size_t>(matrix.cols()));
  const Dissection dissection(groups, positions);
  for (const int g : dissection.order())
    for (int k = groups.first[static_cast<std::size_t>(g)];
         k < groups.first[static_cast<std::size_t>(g) + 1]; ++k)
      order.push_back(k);
  return moved_last(std::move(order), is_last);
}

EliminationOrder minimum_degree(const Matrix& matrix, const std::vector<Index>& last) {
  require(matrix.rows() == matrix.cols(), "minimum_degree: the matrix must be square, got ",
          matrix.rows(), " x ", matrix.cols());
  const std::vector<char> is_last = marked(matrix.cols(), last);
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> to_old;
  Eigen::AMDOrdering<int>()(matrix.selfadjointView<Eigen::Lower>(), to_old);
  return moved_last({to_old.indices().data(), to_old.indices().data() + to_old.size()}, is_last);
}

}  // namespace signorini

#include "addons/frontal/separator_tree.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Matrix = Eigen::SparseMatrix<double>;

/// So many groups are eliminated together rather than cut again: below that, fronts are so small that to walk
/// through them costs more than the zeros that they would save (between 4 and 16 it hardly matters).
constexpr std::size_t leaf = 8;

/// Neighbouring unknowns with equal columns, taken as one: a graph of half the size.
struct Groups {
  std::vector<int> first;      // first unknown of every group, and one entry more at the end
  std::vector<int> start;      // neighbours of group g: from start[g] to start[g + 1]
  std::vector<int> neighbour;  // groups, rising
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

enum Side : char { Nowhere, Left, Right, Between };  // Nowhere: not in the range that is cut

/// A way to part a range.
struct Cut {
  std::vector<char> side;  // of every group of the range
  double left = 0;         // how many groups are on it
  double right = 0;
  double between = 0;

  [[nodiscard]] double price() const {
    return left * right > 0 ? between / (left * right) : std::numeric_limits<double>::infinity();
  }
  [[nodiscard]] bool better_than(const Cut& other) const {
    return price() < other.price() ||
           (price() == other.price() && left * right > other.left * other.right);
  }
};

/// The value below which there is as near to half of the keys as can be. Sorts them in part.
double halving(std::vector<double>& keys) {
  const auto middle = keys.begin() + static_cast<std::ptrdiff_t>(keys.size() / 2);
  std::nth_element(keys.begin(), middle, keys.end());
  const double median = *middle;
  double below = 0;
  double beyond = 0;
  double next = median;
  for (const double key : keys) {
    below += key < median ? 1 : 0;
    beyond += key > median ? 1 : 0;
    if (key > median && (next == median || key < next)) next = key;
  }
  return below >= beyond ? median : next;
}

/// Dissects the groups, range by range.
class Dissection {
 public:
  Dissection(const Groups& groups, const Positions& positions)
      : groups_(groups), side_(groups.first.size() - 1, Nowhere), level_(side_.size()) {
    for (Index axis = 0; positions.rows() > 0 && axis < 2; ++axis) {
      std::vector<double>& coordinate = coordinates_.emplace_back(side_.size());
      for (std::size_t g = 0; g < coordinate.size(); ++g)
        coordinate[g] = positions(groups.first[g], axis);
    }
    Range all(side_.size());
    std::iota(all.begin(), all.end(), 0);
    if (!all.empty()) dissect(std::move(all));
  }
  SeparatorTree tree;

 private:
  using Range = std::vector<int>;  // groups, rising

  struct Neighbours {
    const int* from;
    const int* to;
    [[nodiscard]] const int* begin() const { return from; }
    [[nodiscard]] const int* end() const { return to; }
  };
  [[nodiscard]] Neighbours neighbours(int group) const {
    const int* all = groups_.neighbour.data();
    return {all + groups_.start[at(group)], all + groups_.start[at(group) + 1]};
  }
  [[nodiscard]] bool touches(int group, Side side) const {
    const Neighbours around = neighbours(group);
    return std::any_of(around.begin(), around.end(), [&](int h) { return side_[at(h)] == side; });
  }

  int emit(const Range& groups, std::array<int, 2> below) {
    Separator separator{static_cast<int>(tree.order.size()), 0, below};
    for (const int g : groups)
      for (int k = groups_.first[at(g)]; k < groups_.first[at(g) + 1]; ++k) tree.order.push_back(k);
    separator.own = static_cast<int>(tree.order.size()) - separator.first;
    tree.separators.push_back(separator);
    return static_cast<int>(tree.separators.size()) - 1;
  }

  /// Levels of a search in breadth; a piece that it does not reach follows as if it touched.
  /// \return the group that was reached last
  int search(const Range& range, int begin) {
    for (const int g : range) side_[at(g)] = Right;
    queue_.clear();
    const auto reach = [&](int g, double level) {
      side_[at(g)] = Left;
      level_[at(g)] = level;
      queue_.push_back(g);
    };
    reach(begin, 0);
    auto next = range.begin();
    for (std::size_t k = 0; k < range.size(); ++k) {
      if (k == queue_.size()) {
        while (side_[at(*next)] == Left) ++next;
        reach(*next, level_[at(queue_.back())] + 1);
      }
      const int g = queue_[k];
      for (const int h : neighbours(g))
        if (side_[at(h)] == Right) reach(h, level_[at(g)] + 1);
    }
    return queue_.back();
  }

  /// Gives the groups on one side of the border back to it unless they touch what lies beyond them.
  void trim(const Range& border, Side own, Side other) {
    for (const int g : border) side_[at(g)] = Between;
    for (const int g : border)
      if (!touches(g, own)) side_[at(g)] = other;
  }

  /// Parts a range where a key is halved. The separator is taken from the side where it is smaller.
  Cut cut(const Range& range, const std::vector<double>& key) {
    keys_.resize(range.size());
    std::transform(range.begin(), range.end(), keys_.begin(), [&](int g) { return key[at(g)]; });
    const double value = halving(keys_);
    for (const int g : range) side_[at(g)] = key[at(g)] < value ? Left : Right;
    border_[0].clear();
    border_[1].clear();
    for (const int g : range) {
      if (key[at(g)] >= value) continue;
      bool joined = false;
      for (const int h : neighbours(g)) {
        if (side_[at(h)] == Right) border_[1].push_back(h);
        if (side_[at(h)] == Right) side_[at(h)] = Between;
        joined = joined || side_[at(h)] == Between;
      }
      if (joined) border_[0].push_back(g);
    }
    for (const int h : border_[1]) side_[at(h)] = Right;
    if (border_[1].size() <= border_[0].size())
      trim(border_[1], Right, Left);
    else
      trim(border_[0], Left, Right);
    return read_cut(range);
  }

  [[nodiscard]] Cut read_cut(const Range& range) const {
    Cut cut;
    cut.side.reserve(range.size());
    for (const int g : range) {
      const char side = side_[at(g)];
      cut.side.push_back(side);
      cut.left += side == Left ? 1 : 0;
      cut.right += side == Right ? 1 : 0;
      cut.between += side == Between ? 1 : 0;
    }
    return cut;
  }

  [[nodiscard]] Cut best_cut(const Range& range) {
    Cut best;
    const auto consider = [&](Cut other) {
      if (other.better_than(best)) best = std::move(other);
    };
    for (const std::vector<double>& coordinate : coordinates_) consider(cut(range, coordinate));
    search(range, search(range, range.front()));
    consider(cut(range, level_));
    return best;
  }

  int dissect(Range range) {
    if (range.size() <= leaf) return emit(range, {-1, -1});
    const Cut cut = best_cut(range);
    for (const int g : range) side_[at(g)] = Nowhere;
    if (!(cut.left * cut.right > 0)) return emit(range, {-1, -1});
    std::array<Range, 4> part;
    for (std::size_t k = 0; k < range.size(); ++k) part[at(cut.side[k])].push_back(range[k]);
    range = {};
    const int left = dissect(std::move(part[Left]));
    const int right = dissect(std::move(part[Right]));
    return emit(part[Between], {left, right});
  }

  const Groups& groups_;
  std::vector<char> side_;
  std::vector<double> level_;
  std::vector<std::vector<double>> coordinates_;
  std::vector<double> keys_;
  std::vector<int> queue_;
  std::array<Range, 2> border_;
};

}  // namespace

SeparatorTree separator_tree(const Matrix& matrix, const Positions& positions) {
  require_argument(matrix.rows() == matrix.cols() && matrix.isCompressed(),
                   "separator_tree: need a square matrix after makeCompressed(), got ",
                   matrix.rows(), " x ", matrix.cols());
  require_argument(positions.rows() == 0 || positions.rows() == matrix.cols(),
                   "separator_tree: need one position per unknown or none, got ", positions.rows(),
                   " positions for ", matrix.rows(), " x ", matrix.cols());
  const Groups groups = grouped(matrix);
  return std::move(Dissection(groups, positions).tree);
}

}  // namespace signorini

#include "addons/frontal/cuts.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "signorini/core/index.hpp"

namespace signorini {

using Eigen::Index;
using Matrix = Eigen::SparseMatrix<double>;

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

namespace {

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

}  // namespace

/// A way to part a range.
struct Cuts::Cut {
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

Cuts::Cuts(const Groups& groups, const Positions& positions)
    : groups_(groups), side_(groups.first.size() - 1, Nowhere), level_(side_.size()) {
  for (Index axis = 0; positions.rows() > 0 && axis < 2; ++axis) {
    std::vector<double>& coordinate = coordinates_.emplace_back(side_.size());
    for (std::size_t g = 0; g < coordinate.size(); ++g)
      coordinate[g] = positions(groups.first[g], axis);
  }
}

Cuts::Neighbours Cuts::neighbours(int group) const {
  const int* all = groups_.neighbour.data();
  return {all + groups_.start[at(group)], all + groups_.start[at(group) + 1]};
}

bool Cuts::touches(int group, Side side) const {
  const Neighbours around = neighbours(group);
  return std::any_of(around.begin(), around.end(), [&](int h) { return side_[at(h)] == side; });
}

/// Levels of a search in breadth; a piece that it does not reach follows as if it touched.
/// \return the group that was reached last
int Cuts::search(const Range& range, int begin, Room& room) {
  for (const int g : range) side_[at(g)] = Right;
  room.queue.clear();
  const auto reach = [&](int g, double level) {
    side_[at(g)] = Left;
    level_[at(g)] = level;
    room.queue.push_back(g);
  };
  reach(begin, 0);
  auto next = range.begin();
  for (std::size_t k = 0; k < range.size(); ++k) {
    if (k == room.queue.size()) {
      while (side_[at(*next)] == Left) ++next;
      reach(*next, level_[at(room.queue.back())] + 1);
    }
    const int g = room.queue[k];
    for (const int h : neighbours(g))
      if (side_[at(h)] == Right) reach(h, level_[at(g)] + 1);
  }
  return room.queue.back();
}

/// Gives the groups on one side of the border back to it unless they touch what lies beyond them.
void Cuts::trim(const Range& border, Side own, Side other) {
  for (const int g : border) side_[at(g)] = Between;
  for (const int g : border)
    if (!touches(g, own)) side_[at(g)] = other;
}

/// Parts a range where a key is halved. The separator is taken from the side where it is smaller.
Cuts::Cut Cuts::cut(const Range& range, const std::vector<double>& key, Room& room) {
  auto& [near, far] = room.border;
  room.keys.resize(range.size());
  std::transform(range.begin(), range.end(), room.keys.begin(), [&](int g) { return key[at(g)]; });
  const double value = halving(room.keys);
  for (const int g : range) side_[at(g)] = key[at(g)] < value ? Left : Right;
  near.clear();
  far.clear();
  for (const int g : range) {
    if (key[at(g)] >= value) continue;
    bool joined = false;
    for (const int h : neighbours(g)) {
      if (side_[at(h)] == Right) far.push_back(h);
      if (side_[at(h)] == Right) side_[at(h)] = Between;
      joined = joined || side_[at(h)] == Between;
    }
    if (joined) near.push_back(g);
  }
  for (const int h : far) side_[at(h)] = Right;
  if (far.size() <= near.size())
    trim(far, Right, Left);
  else
    trim(near, Left, Right);
  return read_cut(range);
}

Cuts::Cut Cuts::read_cut(const Range& range) const {
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

Cuts::Cut Cuts::best_cut(const Range& range, Room& room) {
  Cut best;
  const auto consider = [&](Cut other) {
    if (other.better_than(best)) best = std::move(other);
  };
  for (const std::vector<double>& coordinate : coordinates_) consider(cut(range, coordinate, room));
  search(range, search(range, range.front(), room), room);
  consider(cut(range, level_, room));
  return best;
}

/// The groups of a range on either side of its best cut, and between them; none if there is no cut.
std::array<Cuts::Range, 4> Cuts::parted(const Range& range, Room& room) {
  const Cut cut = best_cut(range, room);
  for (const int g : range) side_[at(g)] = Nowhere;
  std::array<Range, 4> part;
  if (!(cut.left * cut.right > 0)) return part;
  for (std::size_t k = 0; k < range.size(); ++k) part[at(cut.side[k])].push_back(range[k]);
  return part;
}

}  // namespace signorini

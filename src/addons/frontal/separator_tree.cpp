#include "addons/frontal/separator_tree.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "addons/frontal/cuts.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/parts.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Matrix = Eigen::SparseMatrix<double>;

/// So many groups are eliminated together rather than cut again: below that, fronts are so small that to walk
/// through them costs more than the zeros that they would save (between 4 and 16 it hardly matters).
constexpr std::size_t leaf = 8;
/// A range with at most so many groups, or a 64th of all, is dissected by one thread: less takes no longer than a thread takes
/// to begin.
constexpr std::size_t smallest_range = 512;

/// Appends a tree of other unknowns behind the last place of one.
/// \return the number of its last separator
int append(SeparatorTree& tree, const SeparatorTree& other) {
  const int first = static_cast<int>(tree.order.size());
  const int number = static_cast<int>(tree.separators.size());
  tree.order.insert(tree.order.end(), other.order.begin(), other.order.end());
  for (Separator separator : other.separators) {
    separator.first += first;
    for (int& below : separator.below)
      if (below >= 0) below += number;
    tree.separators.push_back(separator);
  }
  return static_cast<int>(tree.separators.size()) - 1;
}

/// Dissects the groups: large ranges level by level, those of a level at the same time, and then each small one by itself.
class Dissection {
 public:
  Dissection(const Groups& groups, const Positions& positions)
      : groups_(groups), cuts_(groups, positions), count_(groups.first.size() - 1) {
    if (count_ == 0) return;
    parts_.emplace_back();
    parts_.front().range.resize(count_);
    std::iota(parts_.front().range.begin(), parts_.front().range.end(), 0);
    cut_large_parts();
    std::vector<std::size_t> small;
    for (std::size_t k = 0; k < parts_.size(); ++k)
      if (parts_[k].below.empty()) small.push_back(k);
    for_parts(static_cast<Index>(small.size()), [&](Index k) {
      Part& part = parts_[small[at(k)]];
      Cuts::Room room;
      dissect(std::move(part.range), room, part.tree);
    });
    join(0);
  }
  SeparatorTree tree;

 private:
  using Range = Cuts::Range;

  /// A range, or what stands between the parts that it was cut into.
  struct Part {
    Range range;
    std::vector<std::size_t> below;  // parts that it was cut into
    SeparatorTree tree;              // of a range that was not cut before
  };

  /// Cuts all parts that are large, level by level.
  void cut_large_parts() {
    const std::size_t small = std::max(smallest_range, count_ / 64);
    for (std::size_t begin = 0, end = parts_.size(); begin < end;
         begin = end, end = parts_.size()) {
      std::vector<std::array<Range, 4>> cuts(end - begin);
      for_parts(static_cast<Index>(cuts.size()), [&](Index k) {
        Part& part = parts_[begin + at(k)];
        Cuts::Room room;
        if (part.range.size() > small) cuts[at(k)] = cuts_.parted(part.range, room);
      });
      for (std::size_t k = begin; k < end; ++k) {
        std::array<Range, 4>& cut = cuts[k - begin];
        if (cut[Cuts::Left].empty()) continue;
        parts_[k].range = std::move(cut[Cuts::Between]);
        parts_[k].below = {parts_.size(), parts_.size() + 1};
        for (const Cuts::Side side : {Cuts::Left, Cuts::Right}) {
          parts_.emplace_back();
          parts_.back().range = std::move(cut[at(side)]);
        }
      }
    }
  }

  /// Puts the trees of parts together, those below a part before its own groups. \return the number of the last separator
  int join(std::size_t number) {
    const Part& part = parts_[number];
    if (part.below.empty()) return append(tree, part.tree);
    const int left = join(part.below[0]);
    const int right = join(part.below[1]);
    return emit(part.range, {left, right}, tree);
  }

  int emit(const Range& groups, std::array<int, 2> below, SeparatorTree& into) const {
    Separator separator{static_cast<int>(into.order.size()), 0, below};
    for (const int g : groups)
      for (int k = groups_.first[at(g)]; k < groups_.first[at(g) + 1]; ++k) into.order.push_back(k);
    separator.own = static_cast<int>(into.order.size()) - separator.first;
    into.separators.push_back(separator);
    return static_cast<int>(into.separators.size()) - 1;
  }

  int dissect(Range range, Cuts::Room& room, SeparatorTree& into) {
    if (range.size() <= leaf) return emit(range, {-1, -1}, into);
    std::array<Range, 4> part = cuts_.parted(range, room);
    if (part[Cuts::Left].empty()) return emit(range, {-1, -1}, into);
    range = {};
    const int left = dissect(std::move(part[Cuts::Left]), room, into);
    const int right = dissect(std::move(part[Cuts::Right]), room, into);
    return emit(part[Cuts::Between], {left, right}, into);
  }

  const Groups& groups_;
  Cuts cuts_;
  std::size_t count_;        // of groups
  std::vector<Part> parts_;  // what is above comes before
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

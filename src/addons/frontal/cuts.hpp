// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Cutting a part of a graph in two.
#pragma once
#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "addons/frontal/separator_tree.hpp"

namespace signorini {

/// Neighbouring unknowns with equal columns, taken as one: a graph of half the size.
struct Groups {
  std::vector<int> first;      ///< first unknown of every group, and one entry more at the end
  std::vector<int> start;      ///< neighbours of group g: from start[g] to start[g + 1]
  std::vector<int> neighbour;  ///< groups, rising
};

/// \param K  `n x n` compressed, symmetric pattern, both triangles \return the groups of its unknowns
[[nodiscard]] Groups grouped(const Eigen::SparseMatrix<double>& K);

/// Cuts ranges of groups. Ranges that no entry joins may be cut on several threads at a time: what stands between them is
/// Nowhere for each.
class Cuts {
 public:
  /// Where a group is in the range that is cut.
  enum Side : char { Nowhere, Left, Right, Between };  // Nowhere: not in that range
  using Range = std::vector<int>;                      ///< groups, rising

  /// What one thread needs.
  struct Room {
    std::vector<double> keys;     ///< of the groups of a range
    std::vector<int> queue;       ///< of a search in breadth
    std::array<Range, 2> border;  ///< groups on either side that touch the other one
  };

  /// \param groups     that are to be cut; must outlive this
  /// \param positions  of their unknowns [length]; empty if they are not known
  Cuts(const Groups& groups, const Positions& positions);

  /// Cuts a range.
  /// \param range  of groups \param room  of this thread
  /// \return its groups on either side of the best cut, and between them, by Side; none if there is no cut
  [[nodiscard]] std::array<Range, 4> parted(const Range& range, Room& room);

 private:
  struct Cut;
  struct Neighbours {
    const int* from;
    const int* to;
    [[nodiscard]] const int* begin() const { return from; }
    [[nodiscard]] const int* end() const { return to; }
  };
  [[nodiscard]] Neighbours neighbours(int group) const;
  [[nodiscard]] bool touches(int group, Side side) const;
  int search(const Range& range, int begin, Room& room);
  void trim(const Range& border, Side own, Side other);
  [[nodiscard]] Cut cut(const Range& range, const std::vector<double>& key, Room& room);
  [[nodiscard]] Cut read_cut(const Range& range) const;
  [[nodiscard]] Cut best_cut(const Range& range, Room& room);

  const Groups& groups_;
  std::vector<char> side_;
  std::vector<double> level_;
  std::vector<std::vector<double>> coordinates_;
};

}  // namespace signorini

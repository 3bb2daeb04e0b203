// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Which of many numbers hang together.
///
/// *Union-find*: every number points to a smaller one of its set or to itself, and the one that points to itself names the set.
/// Where two sets join, the larger name then points to the smaller one. So {0, 1, 2} and {3, 4} are two sets of five numbers, and
/// joining 2 with 4 makes them one, called 0.
#pragma once
#include <algorithm>
#include <numeric>
#include <vector>

#include "signorini/core/index.hpp"

namespace signorini {

/// Sets of the numbers 0 to n - 1, each alone at first.
class DisjointSets {
 public:
  /// \param count  n
  explicit DisjointSets(Eigen::Index count) : above_(at(count)), left_(count) {
    std::iota(above_.begin(), above_.end(), Eigen::Index{0});
  }
  /// Every number on the way gets a new pointer, to where its old one points next (path halving), so that a question takes hardly
  /// more than one step.
  /// \param i  a number \return the smallest one of its set
  [[nodiscard]] Eigen::Index name(Eigen::Index i) {
    while (above_[at(i)] != i) i = above_[at(i)] = above_[at(above_[at(i)])];
    return i;
  }
  /// Makes two sets one. \param i  a number of one \param j  a number of the other
  void join(Eigen::Index i, Eigen::Index j) {
    i = name(i);
    j = name(j);
    if (i == j) return;
    above_[at(std::max(i, j))] = std::min(i, j);
    --left_;
  }
  /// \return the number of sets
  [[nodiscard]] Eigen::Index count() const { return left_; }

 private:
  std::vector<Eigen::Index> above_;
  Eigen::Index left_;
};

}  // namespace signorini

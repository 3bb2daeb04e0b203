/// \file
/// What fronts hand to the fronts above them.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "signorini/core/alignment.hpp"

namespace signorini {

/// Where on one stack the fronts of a tree put what they hand on, known without any of it.
class StackPlan {
 public:
  StackPlan() = default;
  /// \param below  of each separator of a tree
  /// \param sizes  how many numbers each of them hands on
  StackPlan(const std::vector<std::array<int, 2>>& below, std::vector<Eigen::Index> sizes)
      : sizes_(std::move(sizes)), begin_(sizes_.size()) {
    Eigen::Index top = 0;
    for (std::size_t s = 0; s < sizes_.size(); ++s) {
      most_ = std::max(most_, top + sizes_[s]);
      begin_[s] = top;
      for (const int part : below[s])
        if (part >= 0) begin_[s] = std::min(begin_[s], begin_[static_cast<std::size_t>(part)]);
      top = begin_[s] + sizes_[s];
    }
  }

  /// \return the most numbers that are on the stack at a time
  [[nodiscard]] Eigen::Index most() const { return most_; }
  /// \param separator  any \return how many numbers it hands on
  [[nodiscard]] Eigen::Index size(int separator) const {
    return sizes_[static_cast<std::size_t>(separator)];
  }
  /// \param separator  any \return where what it hands on begins
  [[nodiscard]] Eigen::Index begin(int separator) const {
    return begin_[static_cast<std::size_t>(separator)];
  }

 private:
  std::vector<Eigen::Index> sizes_;
  std::vector<Eigen::Index> begin_;
  Eigen::Index most_ = 0;
};

/// One block of memory for a walk up a tree of separators: what a front hands on is built behind what
/// those below it left, and then takes its place.
class FrontStack {
 public:
  /// \param plan  of the walk
  explicit FrontStack(StackPlan plan) : plan_(std::move(plan)), numbers_(plan_.most()) {}

  /// \return where the next separator in the order of the tree may build what it hands on
  [[nodiscard]] double* open() { return numbers_.data() + top_; }
  /// \param separator  that was kept, and none above it \return what it hands on
  [[nodiscard]] const double* kept(int separator) const {
    return numbers_.data() + plan_.begin(separator);
  }
  /// Keeps what was built, and no longer what those below handed on.
  /// \param separator  whose turn it was
  void keep(int separator) {
    const Eigen::Index begin = plan_.begin(separator);
    if (begin < top_) std::copy(open(), open() + plan_.size(separator), numbers_.data() + begin);
    top_ = begin + plan_.size(separator);
  }
  /// \return memory of the block [byte]
  [[nodiscard]] long long bytes() const {
    return numbers_.size() * static_cast<long long>(sizeof(double));
  }

 private:
  StackPlan plan_;
  Eigen::Index top_ = 0;
  Eigen::VectorXd numbers_;
};

}  // namespace signorini

/// \file
/// What fronts hand to the fronts above them.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace signorini {

/// One block of memory for a walk up a tree of separators: what a front hands on is built behind what
/// those below it left, and then takes its place.
class FrontStack {
 public:
  /// \param below  of each separator of a tree
  /// \param sizes  how many numbers each of them hands on
  FrontStack(const std::vector<std::array<int, 2>>& below, std::vector<Eigen::Index> sizes)
      : sizes_(std::move(sizes)), begin_(sizes_.size()) {
    Eigen::Index most = 0;
    for (std::size_t s = 0; s < sizes_.size(); ++s) {
      most = std::max(most, top_ + sizes_[s]);
      begin_[s] = top_;
      for (const int part : below[s])
        if (part >= 0) begin_[s] = std::min(begin_[s], begin_[static_cast<std::size_t>(part)]);
      top_ = begin_[s] + sizes_[s];
    }
    top_ = 0;
    numbers_.resize(most);
  }

  /// \return where the next separator in the order of the tree may build what it hands on
  [[nodiscard]] double* open() { return numbers_.data() + top_; }
  /// \param separator  that was kept, and none above it \return what it hands on
  [[nodiscard]] const double* kept(int separator) const {
    return numbers_.data() + begin_[static_cast<std::size_t>(separator)];
  }
  /// Keeps what was built, and no longer what those below handed on.
  /// \param separator  whose turn it was
  void keep(int separator) {
    const std::size_t s = static_cast<std::size_t>(separator);
    if (begin_[s] < top_) std::copy(open(), open() + sizes_[s], numbers_.data() + begin_[s]);
    top_ = begin_[s] + sizes_[s];
  }

 private:
  std::vector<Eigen::Index> sizes_;
  std::vector<Eigen::Index> begin_;
  Eigen::Index top_ = 0;
  Eigen::VectorXd numbers_;
};

}  // namespace signorini

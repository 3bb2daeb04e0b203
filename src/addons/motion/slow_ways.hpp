// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// How much of its way an iteration goes, if the last ones have hardly come closer.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/problem/problem.hpp"

namespace signorini {

/// The ways of a loop, one after the other.
class SlowWays {
 public:
  /// \param way       of the next iteration, to where its linear problem has the unknowns [length]
  /// \param statuses  of the pairs on it
  /// \return the share of it to go: 1, unless the pairs do what they did, two ways have been slow, and this is more than
  ///   half of the last one
  [[nodiscard]] double share(const Eigen::VectorXd& way,
                             const std::vector<ContactStatus>& statuses) const;
  /// Remembers a way that was gone. \param way  as above \param statuses  as above \param share  that was gone of it
  void gone(const Eigen::VectorXd& way, const std::vector<ContactStatus>& statuses, double share);

 private:
  [[nodiscard]] bool is_slow(const Eigen::VectorXd& way,
                             const std::vector<ContactStatus>& statuses) const;

  Eigen::VectorXd way_;
  std::vector<ContactStatus> statuses_;
  double share_ = 0;
  int slow_ = 0;  // ways in a row; remembered while pairs do the same
};

}  // namespace signorini

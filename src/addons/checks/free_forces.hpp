// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The forces of a solution that may change, and which of them can be exchanged for each other.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "addons/checks/elimination.hpp"
#include "addons/checks/undetermined.hpp"

namespace signorini {

/// The forces of a solution in units of what they move, and which of them may change.
class FreeForces {
 public:
  /// \param carried  a solution, which must outlive this
  explicit FreeForces(const Carried& carried);

  /// \return groups of pairs that share exchanges, without how far their forces go
  [[nodiscard]] std::vector<SharedForces> groups() const;
  /// \return `n_c + n_s` > 0: of all rows force * unit is in one unit, the length of the column of the effect
  [[nodiscard]] const Eigen::VectorXd& unit() const { return unit_; }
  /// \return the largest force in these units
  [[nodiscard]] double largest_force() const { return largest_; }
  /// \param pair  any \return the row of its friction force; -1 if it has no friction
  [[nodiscard]] Eigen::Index slip_row(Eigen::Index pair) const;
  /// \param pair  any \return whether its friction force is free within its bound
  [[nodiscard]] bool sticks(Eigen::Index pair) const;

 private:
  /// A force that may change, with the friction force that follows it where its pair slides.
  struct One {
    Eigen::Index pair;
    Eigen::Index row;
    Eigen::Index slip = -1;
    double slope = 0;
  };

  void add(Eigen::Index pair);
  /// A basis of the changes of the free forces that do nothing, one sparse vector each.
  [[nodiscard]] std::vector<SparseEntries> exchanges() const;
  [[nodiscard]] SharedForces group_of(const std::vector<SparseEntries>& members) const;

  const Carried& carried_;
  Eigen::Index pairs_;
  Eigen::VectorXd unit_;
  double largest_;
  std::vector<Eigen::Index> slip_row_;  ///< of each pair
  std::vector<One> free_;
  std::vector<bool> sticks_;  ///< of each pair
};

}  // namespace signorini

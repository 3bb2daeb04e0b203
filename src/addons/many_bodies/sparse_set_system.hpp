// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The equations of a SparseContact for one set of closed pairs after the other.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "addons/many_bodies/sparse_contact.hpp"
#include "signorini/problem/active_set_system.hpp"

namespace signorini {

/// The system of one set after the other, in units in which forces and movements are alike. It begins without forces, and each set
/// from the numbers of the one before.
class SparseSetSystem {
 public:
  /// \param problem  sizes fit
  explicit SparseSetSystem(const SparseContact& problem);

  /// \return whether there is no x: rigid bodies, whose forces may be redundant
  [[nodiscard]] bool alone() const { return x_.size() == 0; }
  /// \return free movements and law in these units, no more
  [[nodiscard]] const ScaledProblem& units() const { return units_; }
  /// \return F in these units
  [[nodiscard]] const Eigen::SparseMatrix<double>& compliance() const { return F_; }

  /// Solves a set.
  /// \param set   closed rows and sliding pairs
  /// \param soft  what closed rows give way by [-]
  /// \return whether there are numbers, settled or not
  bool solve(const ActiveSet& set, double soft);
  /// \return whether the last corrections of the last set were rounding
  [[nodiscard]] bool settled() const { return settled_; }
  /// Notes movements, and what rounding may have done to them and to forces.
  /// \param set  closed rows and sliding pairs
  void settle(const ActiveSet& set);
  /// Takes forces over, with the movements that follow, and without roundings. \param numbers  forces in these units
  void take(ActiveSetSolution numbers);
  /// \return forces and movements in these units
  [[nodiscard]] const ActiveSetSolution& now() const { return now_; }
  /// \param[out] found  x, f and w in the units of the problem
  void write(SparseContactSolution& found) const;

 private:
  /// \return whether closed rows have moved by no more than rounding
  bool closes(const ActiveSet& set);
  /// \return the matrix of a set
  [[nodiscard]] Eigen::SparseMatrix<double> matrix(const ActiveSet& set, double soft) const;
  /// What is added to the diagonal. What rounding leaves of a residual moves redundant forces by epsilon over it.
  [[nodiscard]] double regularity() const;
  /// \return p - H x - B^T f, rounded once
  [[nodiscard]] Eigen::VectorXd imbalance() const;
  /// \return g - B x + F f, rounded once
  [[nodiscard]] Eigen::VectorXd movement() const;

  Eigen::VectorXd row_scale_, column_scale_;
  Eigen::SparseMatrix<double> B_, BT_, H_, F_;
  Eigen::VectorXd load_;
  ScaledProblem units_;
  Eigen::VectorXd x_, low_;
  ActiveSetSolution now_;
  bool settled_ = false;
};

}  // namespace signorini

// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The tableau of the simplex method with restricted basis entry.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/core/rounding.hpp"
#include "signorini/problem/active_set_system.hpp"

namespace signorini {

/// The tableau B^-1 [I, -G | d] of gap - G force = d. Variables 0, ..., n - 1 are the gaps, n, ..., 2n - 1
/// the forces, and column 2n holds the values of the basis. An artificial variable is minus a gap or
/// minus a force: the amount by which that one is negative.
class SimplexTableau {
 public:
  /// Starts from the basis that closes some pairs and no others; what is negative there turns artificial.
  /// \param problem  scaled, without friction; must outlive this \param closed  the pairs, independent
  SimplexTableau(const ScaledProblem& problem, const std::vector<Eigen::Index>& closed);
  /// \return the variable whose entry lowers the sum most and whose partner is not in the basis, or -1
  [[nodiscard]] Eigen::Index entering() const;
  /// \param column  the variable that enters
  /// \return the row whose variable reaches zero first, or -1; of equal rows the lexicographic rule takes one
  [[nodiscard]] Eigen::Index leaving(Eigen::Index column) const;
  /// Exchanges two variables. \param row  of the one that leaves \param column  the one that enters
  void pivot(Eigen::Index row, Eigen::Index column);
  /// \return the sum of the artificial variables, which the method makes zero [sqrt(energy)]
  [[nodiscard]] double artificial_sum() const { return artificial_.dot(values().cwiseMax(0.0)); }
  /// \return whether nothing but rounding is left of that sum
  [[nodiscard]] bool feasible() const { return artificial_sum() <= rounding() * first_sum_; }
  /// \return pairs whose force is in the basis, the largest force first
  [[nodiscard]] std::vector<Eigen::Index> closed() const;
  /// \return forces and gaps of the basis; an artificial number is an overlap or a tension
  [[nodiscard]] ActiveSetSolution numbers() const;
  /// \param first_sum  artificial_sum() of the first basis \return one entry of the history
  [[nodiscard]] Iteration summary(double first_sum) const;
  /// \return minus the prices of the equations if they prove that nothing solves the problem, else nothing
  [[nodiscard]] Eigen::VectorXd proof() const;

 private:
  [[nodiscard]] Eigen::Index basis(Eigen::Index row) const {
    return basis_[static_cast<std::size_t>(row)];
  }
  [[nodiscard]] Eigen::MatrixXd::ConstColXpr values() const { return rows_.col(2 * n_); }
  [[nodiscard]] double rounding() const { return static_cast<double>(n_ + 1) * epsilon; }

  /// Keeps the rows whose entry in a column, times a sign, over the pivot is smallest to rounding.
  void keep_smallest(std::vector<Eigen::Index>& rows, Eigen::Index column, Eigen::Index of,
                     double sign) const;

  const ScaledProblem* problem_;
  Eigen::Index n_;
  Eigen::MatrixXd rows_;
  std::vector<Eigen::Index> basis_;  ///< the variable of each row
  Eigen::VectorXd artificial_;  ///< 1 where it is an artificial one, minus that variable; else 0
  std::vector<Eigen::Index> first_;   ///< the basis at the start, whose columns order equal rows
  Eigen::VectorXd first_artificial_;  ///< and its marks
  double first_sum_ = 0;
};

}  // namespace signorini

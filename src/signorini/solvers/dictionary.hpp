// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The equations of complementary pivoting, solved for one basis after the other.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/core/index.hpp"
#include "signorini/problem/scaled.hpp"

namespace signorini {

/// The equations w = M z + c z_0 + q, solved for n of their 2 n + 1 variables, the basis, in terms of
/// the others. Variable j < n is the gap w_j, n + j the force z_j, and 2 n is z_0.
///
/// Numbers that rounding may have made of zeros count as zeros: those below (n + pivots) epsilon times
/// the largest of their column.
class Dictionary {
 public:
  /// The basis of all gaps.
  /// \param problem   M and q, scaled by equilibrate_any()
  /// \param covering  c `n` > 0, scaled like q
  Dictionary(const ScaledProblem& problem, const Eigen::VectorXd& covering);

  /// \return the variable z_0
  [[nodiscard]] Eigen::Index artificial() const { return 2 * n_; }
  /// \param variable  a gap or a force
  /// \return the other one of the same pair
  [[nodiscard]] Eigen::Index partner(Eigen::Index variable) const {
    return variable < n_ ? variable + n_ : variable - n_;
  }
  /// \param row  from 0
  /// \return its basic variable
  [[nodiscard]] Eigen::Index basic(Eigen::Index row) const { return basic_[at(row)]; }
  /// \return values `n` of the basic variables, row by row
  [[nodiscard]] auto value() const { return rows_.col(n_ + 1); }
  /// \param variable  not in the basis
  /// \return by how much each basic variable changes per unit of it `n`
  [[nodiscard]] auto column(Eigen::Index variable) const { return rows_.col(place_[at(variable)]); }

  /// Finds the gap that blocks z_0 when it falls from infinity in the first basis.
  /// \return its row; of several the last, by the lexicographic rule
  [[nodiscard]] Eigen::Index first_row() const;

  /// Finds the basic variable that first becomes zero when another variable grows from zero.
  ///
  /// Of several z_0 is preferred, which ends the method; otherwise the lexicographic rule chooses as if
  /// \f$ q_j \f$ were \f$ q_j + \delta^j \f$ with a tiny \f$ \delta \f$.
  /// \param entering  not in the basis
  /// \return its row, or -1 if none ever becomes zero
  [[nodiscard]] Eigen::Index blocking_row(Eigen::Index entering);

  /// Exchanges a basic variable for another one.
  /// \param row       of the variable that leaves the basis
  /// \param entering  the variable that takes its place
  void pivot(Eigen::Index row, Eigen::Index entering);

 private:
  [[nodiscard]] double rounding() const;
  [[nodiscard]] bool is_basic(Eigen::Index variable) const;
  [[nodiscard]] double perturbation(Eigen::Index row, Eigen::Index j) const;
  void keep_smallest(Eigen::Index j, Eigen::Index entering);

  Eigen::Index n_;
  Eigen::MatrixXd
      rows_;  ///< `n x (n + 2)`: the n + 1 variables outside of the basis, and constants
  Eigen::VectorXd column_;
  Eigen::VectorXd row_;
  Eigen::Index pivots_ = 0;
  std::vector<Eigen::Index> basic_;
  std::vector<Eigen::Index> nonbasic_;
  std::vector<Eigen::Index> place_;  ///< of each variable: its row or its column
  std::vector<Eigen::Index> ties_;
};

}  // namespace signorini

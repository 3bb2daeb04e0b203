/// \file
/// Exercise 20.1 - one exchange of a linear programme with restricted basis entry. Do not change this file.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace ex20_1 {

using Eigen::Index;

/// The equations w - G lambda - z = d, solved for n of their variables.
///
/// Variable i < n is the gap w_i, n + i the force lambda_i. Column j of `rows` belongs to variable j, and the last one holds
/// the values: the basic variable of row i is rows(i, 2 n) - rows(i, j) x_j if variable j outside of the basis grows to x_j.
/// Where `artificial` is set, the basic variable is the overlap z_i, and `basic` has the gap that it stands for.
struct Tableau {
  Eigen::MatrixXd rows;          ///< `n x (2 n + 1)`, the last column not negative
  std::vector<Index> basic;      ///< `n`: which variable each row is solved for
  std::vector<bool> artificial;  ///< `n`: whether that is an overlap

  /// \return number of pairs
  [[nodiscard]] Index pairs() const { return rows.rows(); }
};

/// Which variable joins: of those that lower the sum of the artificial ones, by more than 1e-12 for each unit, the one that does so
/// fastest, the first of several; but none whose partner, the force of its gap or the gap of its force, is in the basis.
/// \param tableau  any
/// \return the variable, or -1 if there is none
[[nodiscard]] Index joining(const Tableau& tableau);

/// The ratio test: the row whose basic variable is the first to become zero, the first of several.
/// \param tableau   any
/// \param variable  that joins
/// \return the row, or -1 if no entry of its column is above 1e-12
[[nodiscard]] Index leaving(const Tableau& tableau, Index variable);

/// \param G  `n x n` compliance \param d  `n` gaps without contact \return the first table: all gaps, and overlaps where they are < 0
inline Tableau start(const Eigen::MatrixXd& G, const Eigen::VectorXd& d) {
  const Index n = d.size();
  Tableau tableau{Eigen::MatrixXd(n, 2 * n + 1), {}, {}};
  tableau.rows << Eigen::MatrixXd::Identity(n, n), -G, d;
  for (Index i = 0; i < n; ++i) {
    tableau.basic.push_back(i);
    tableau.artificial.push_back(d(i) < 0);
    if (d(i) < 0) tableau.rows.row(i) *= -1;
  }
  return tableau;
}

/// Gauss and Jordan. \param tableau  is changed \param row  whose variable leaves \param variable  that joins
inline void exchange(Tableau& tableau, Index row, Index variable) {
  tableau.rows.row(row) /= tableau.rows(row, variable);
  Eigen::VectorXd factor = tableau.rows.col(variable);
  factor(row) = 0;
  tableau.rows -= factor * tableau.rows.row(row).eval();
  tableau.basic[static_cast<std::size_t>(row)] = variable;
  tableau.artificial[static_cast<std::size_t>(row)] = false;
}

/// How a run ended.
struct Run {
  std::vector<Index> joined;  ///< one for each exchange
  double left = 0;            ///< sum of the overlaps at the end [length]
  Eigen::VectorXd force;      ///< `n` of the last basis
};

/// The method, driven by your two functions.
/// \param G  `n x n` compliance \param d  `n` gaps without contact \param limit  on exchanges \return the run
inline Run solve(const Eigen::MatrixXd& G, const Eigen::VectorXd& d, int limit = 1000) {
  Tableau tableau = start(G, d);
  const Index n = tableau.pairs();
  Run run;
  while (limit-- > 0) {
    const Index variable = joining(tableau);
    const Index row = variable < 0 ? -1 : leaving(tableau, variable);
    if (row < 0) break;
    exchange(tableau, row, variable);
    run.joined.push_back(variable);
  }
  run.force = Eigen::VectorXd::Zero(n);
  for (Index i = 0; i < n; ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    if (tableau.artificial[k])
      run.left += tableau.rows(i, 2 * n);
    else if (tableau.basic[k] >= n)
      run.force(tableau.basic[k] - n) = tableau.rows(i, 2 * n);
  }
  return run;
}

}  // namespace ex20_1

/// \file
/// Exercise 5.1 - one pivot of Lemke's method. Do not change this file.
#pragma once
#include <Eigen/Core>
#include <numeric>
#include <vector>

#include "signorini/problem/problem.hpp"

namespace ex5_1 {

using Eigen::Index;

/// The equations w - M z - c z_0 = q, solved for n of their 2 n + 1 variables.
///
/// Variable i < n is the gap w_i, n + i the force z_i, and 2 n is z_0. Column j of `rows` belongs to
/// variable j and the last one holds the values: the basic variable of row i is
/// rows(i, 2 n + 1) - rows(i, j) x_j if variable j outside of the basis grows to x_j.
struct Tableau {
  Eigen::MatrixXd rows;      ///< `n x (2 n + 2)`; the column of a basic variable is a unit vector
  std::vector<Index> basic;  ///< `n`: which variable each row is solved for
};

/// The ratio test: the row whose basic variable is the first to become zero.
///
/// If z_0 is among several, z_0. Otherwise ties are broken by the lexicographic rule: of the tied rows,
/// each divided by its entry in the entering column, the one whose numbers in the columns 0, ..., n - 1
/// are the smallest, compared from the left. Ratios that differ by less than 1e-12 count as tied.
/// \param tableau   basic variables not negative
/// \param entering  variable outside of the basis that grows
/// \return the row, or -1 if no entry of the entering column is above 1e-12
[[nodiscard]] Index blocking_row(const Tableau& tableau, Index entering);

/// One pivot: solves a row for the entering variable and eliminates it from all others.
/// \param tableau   is changed, rows and basic variables
/// \param row       whose basic variable leaves
/// \param entering  takes its place; its entry in the row is not zero
void pivot(Tableau& tableau, Index row, Index entering);

/// How the path ended.
struct Path {
  bool solved = false;    ///< z_0 has left
  Eigen::VectorXd force;  ///< `n` z of the last basis
  int pivots = 0;         ///< the one that brings z_0 in is the first
};

/// Lemke's method, driven by your two functions.
/// \param problem  M and q
/// \param c        covering vector `n` > 0
/// \param limit    on pivots
/// \return the path
inline Path drive(const signorini::ContactProblem& problem, const Eigen::VectorXd& c, int limit) {
  const Index n = c.size();
  Tableau tableau{Eigen::MatrixXd(n, 2 * n + 2), std::vector<Index>(static_cast<std::size_t>(n))};
  tableau.rows << Eigen::MatrixXd::Identity(n, n), -problem.compliance, -c, problem.free_gap;
  std::iota(tableau.basic.begin(), tableau.basic.end(), Index{0});
  Path path{true, Eigen::VectorXd::Zero(n)};
  if (problem.free_gap.minCoeff() >= 0) return path;
  // [path]
  Index entering = 2 * n;  // z_0
  Index row = 0;           // where z_0 must be largest; of several, the last
  for (Index i = 1; i < n; ++i)
    if (problem.free_gap(i) / c(i) <= problem.free_gap(row) / c(row)) row = i;
  while (row >= 0 && path.pivots < limit) {
    const Index leaving = tableau.basic[static_cast<std::size_t>(row)];
    pivot(tableau, row, entering);
    ++path.pivots;
    if (leaving == 2 * n) break;
    entering = leaving < n ? leaving + n : leaving - n;  // the partner of what has left
    row = blocking_row(tableau, entering);
  }
  // [path]
  for (Index i = 0; i < n; ++i) {
    const Index variable = tableau.basic[static_cast<std::size_t>(i)];
    if (variable == 2 * n) path.solved = false;
    if (variable >= n && variable < 2 * n) path.force(variable - n) = tableau.rows(i, 2 * n + 1);
  }
  return path;
}

}  // namespace ex5_1

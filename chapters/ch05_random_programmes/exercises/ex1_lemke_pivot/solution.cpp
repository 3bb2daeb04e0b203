#include <cmath>

#include "exercise.hpp"

namespace ex5_1 {

Index blocking_row(const Tableau& tableau, Index entering) {
  const Eigen::MatrixXd& rows = tableau.rows;
  const Index n = rows.rows();
  const auto variable = [&](Index i) { return tableau.basic[static_cast<std::size_t>(i)]; };
  const auto ratio = [&](Index i, Index j) { return rows(i, j) / rows(i, entering); };
  // Whether row i goes before row k: values first, then the columns 0, ..., n - 1 from the left.
  const auto before = [&](Index i, Index k) {
    const double first = ratio(i, 2 * n + 1) - ratio(k, 2 * n + 1);
    if (std::abs(first) > 1e-12) return first < 0;
    if (variable(i) == 2 * n || variable(k) == 2 * n) return variable(i) == 2 * n;
    for (Index j = 0; j < n; ++j) {
      const double next = ratio(i, j) - ratio(k, j);
      if (std::abs(next) > 1e-12) return next < 0;
    }
    return false;
  };
  Index row = -1;
  for (Index i = 0; i < n; ++i)
    if (rows(i, entering) > 1e-12 && (row < 0 || before(i, row))) row = i;
  return row;
}

void pivot(Tableau& tableau, Index row, Index entering) {
  Eigen::MatrixXd& rows = tableau.rows;
  rows.row(row) /= rows(row, entering);
  for (Index i = 0; i < rows.rows(); ++i)
    if (i != row) rows.row(i) -= rows(i, entering) * rows.row(row).eval();
  tableau.basic[static_cast<std::size_t>(row)] = entering;
}

}  // namespace ex5_1

#include "addons/checks/elimination.hpp"

#include <Eigen/SparseQR>
#include <algorithm>
#include <cmath>

#include "signorini/core/dense.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

/// Whether columns that fill most of a matrix are independent beyond doubt: if E^T E, of columns of length 1, is positive definite
/// less what rounding can be. Elimination of such columns takes longer than to solve their problem.
bool surely_independent(const SparseMatrix& E) {
  const Index n = E.cols();
  if (n > E.rows() || 2 * E.nonZeros() < n * E.rows()) return false;
  MatrixXd full = E;
  for (auto column : full.colwise()) column.normalize();
  MatrixXd products = full.transpose() * full;
  products.diagonal().array() -=
      static_cast<double>(n) * static_cast<double>(n + E.rows()) * epsilon;
  return CholeskyFactor(products).positive();
}

/// The combination of a column with those that it depends on, by their factors.
SparseEntries combination(Index column, const VectorXd& factor, const Eigen::VectorXi& order,
                          double share) {
  const double most = std::max(1.0, largest(factor));
  SparseEntries result{{column, 1 / most}};
  for (Index k = 0; k < factor.size(); ++k)
    if (std::abs(factor(k)) > share * most) result.emplace_back(order(k), -factor(k) / most);
  return result;
}

}  // namespace

std::vector<SparseEntries> null_combinations(const std::vector<SparseEntries>& columns, Index rows,
                                             double share) {
  std::vector<Eigen::Triplet<double>> entries;
  VectorXd unit = VectorXd::Ones(static_cast<Index>(columns.size()));
  for (Index j = 0; j < unit.size(); ++j) {
    double most = 0;
    for (const auto& [row, value] : columns[at(j)]) most = std::max(most, std::abs(value));
    if (most > 0) unit(j) = most;
    for (const auto& [row, value] : columns[at(j)])
      entries.emplace_back(static_cast<int>(row), static_cast<int>(j), value / unit(j));
  }
  SparseMatrix E(rows, unit.size());
  E.setFromTriplets(entries.begin(), entries.end());
  if (unit.size() == 0 || surely_independent(E)) return {};
  Eigen::SparseQR<SparseMatrix, Eigen::COLAMDOrdering<int>> qr;
  qr.setPivotThreshold(share);
  qr.compute(E);
  const Eigen::VectorXi order = qr.colsPermutation().indices();
  const Index rank = qr.rank();
  // Its columns are in no order; row by row they are.
  const Eigen::SparseMatrix<double, Eigen::RowMajor> by_rows = qr.matrixR();
  const SparseMatrix R = by_rows.topRows(rank);
  std::vector<SparseEntries> all;
  for (Index j = rank; j < unit.size(); ++j) {
    VectorXd factor = R.col(j);
    R.leftCols(rank).triangularView<Eigen::Upper>().solveInPlace(factor);
    for (Index k = 0; k < rank; ++k) factor(k) *= unit(order(j)) / unit(order(k));
    all.push_back(combination(order(j), factor, order, share));
  }
  return all;
}

}  // namespace signorini

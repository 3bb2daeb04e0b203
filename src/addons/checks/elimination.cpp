#include "addons/checks/elimination.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseQR>
#include <algorithm>
#include <cmath>

#include "signorini/core/dense.hpp"
#include "signorini/core/disjoint_sets.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

/// Columns that hang together by their rows, and how many rows and entries these columns have.
struct Part {
  std::vector<Index> columns = {};
  Index rows = 0, entries = 0;
};

/// What rounding can make of E^T E, of n columns of length 1, and of its Cholesky factor.
double rounding_of(Index columns, Index rows) {
  return static_cast<double>(columns) * static_cast<double>(columns + rows) * epsilon;
}

/// Whether columns are independent beyond doubt: if E^T E, of columns of length 1, is positive definite less what rounding can be.
bool surely_independent(MatrixXd E) {
  for (auto column : E.colwise()) column.normalize();
  MatrixXd products = E.transpose() * E;
  products.diagonal().array() -= rounding_of(E.cols(), E.rows());
  return CholeskyFactor(products).positive();
}

/// The same of columns with few entries.
bool surely_independent(SparseMatrix E) {
  for (Index j = 0; j < E.cols(); ++j) {
    const double length = E.col(j).norm();
    if (length == 0) return false;
    E.col(j) /= length;
  }
  SparseMatrix products = E.transpose() * E;
  for (Index j = 0; j < E.cols(); ++j) products.coeffRef(j, j) -= rounding_of(E.cols(), E.rows());
  const Eigen::SimplicialLDLT<SparseMatrix> factor(products);
  return factor.info() == Eigen::Success && (factor.vectorD().array() > 0).all();
}

/// The same part by part, as columns that have no row in common cannot depend on each other: nodes that meet rigid obstacles are
/// parts of at most two rows. Those that are mostly filled are looked at one by one, and what is left by its entries: elimination with
/// pivots takes far longer than either.
bool surely_independent_by_parts(const SparseMatrix& E) {
  DisjointSets sets(E.cols());
  std::vector<Index> first(at(E.rows()), -1), place(at(E.rows()));  // column, number in its part
  for (Index j = 0; j < E.cols(); ++j)
    for (SparseMatrix::InnerIterator it(E, j); it; ++it) {
      Index& column = first[at(it.row())];
      if (column < 0) column = j;
      sets.join(column, j);
    }
  std::vector<Part> parts(at(E.cols()));
  for (Index j = 0; j < E.cols(); ++j) {
    Part& part = parts[at(sets.name(j))];
    part.columns.push_back(j);
    part.entries += E.col(j).nonZeros();
  }
  for (Index i = 0; i < E.rows(); ++i)
    if (first[at(i)] >= 0) place[at(i)] = parts[at(sets.name(first[at(i)]))].rows++;
  std::vector<Index> sparse;  // columns of parts that are not mostly filled
  const bool others = std::all_of(parts.begin(), parts.end(), [&](const Part& part) {
    const Index n = static_cast<Index>(part.columns.size());
    if (n > part.rows) return false;
    if (2 * part.entries < n * part.rows) {
      sparse.insert(sparse.end(), part.columns.begin(), part.columns.end());
      return true;
    }
    MatrixXd full = MatrixXd::Zero(part.rows, n);
    for (Index k = 0; k < n; ++k)
      for (SparseMatrix::InnerIterator it(E, part.columns[at(k)]); it; ++it)
        full(place[at(it.row())], k) = it.value();
    return n == 0 || surely_independent(std::move(full));
  });
  if (!others || sparse.empty()) return others;
  SparseMatrix left(E.rows(), static_cast<Index>(sparse.size()));
  for (std::size_t k = 0; k < sparse.size(); ++k) left.col(static_cast<Index>(k)) = E.col(sparse[k]);
  return surely_independent(std::move(left));
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
  if (surely_independent_by_parts(E)) return {};
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

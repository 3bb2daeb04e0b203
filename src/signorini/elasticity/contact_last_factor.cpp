#include "signorini/elasticity/contact_last_factor.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <limits>

#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Matrix = Eigen::SparseMatrix<double>;
using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;
using Cholesky = Eigen::SimplicialLDLT<Matrix, Eigen::Upper, Eigen::NaturalOrdering<int>>;

/// Position of every unknown in an elimination order.
Permutation positions(const std::vector<int>& order) {
  Permutation to_new(static_cast<Index>(order.size()));
  for (std::size_t k = 0; k < order.size(); ++k) to_new.indices()(order[k]) = static_cast<int>(k);
  return to_new;
}

Matrix reordered(const Matrix& K, const Permutation& to_new) {
  Matrix upper(K.rows(), K.cols());
  upper.selfadjointView<Eigen::Upper>() = K.selfadjointView<Eigen::Lower>().twistedBy(to_new);
  return upper;
}

/// Multiplications and additions of the factorisation, from the column lengths of L.
double operation_count(const Cholesky& factor) {
  const Matrix& L = factor.matrixL().nestedExpression();
  double operations = 0;
  for (Index k = 0; k < L.cols(); ++k) {
    const double below = L.outerIndexPtr()[k + 1] - L.outerIndexPtr()[k];
    operations += below * (below + 2);
  }
  return operations;
}

}  // namespace

struct ContactLastFactor::Parts {
  Permutation to_new;
  std::unique_ptr<Cholesky> factor;
  Eigen::VectorXd pivots;
  Index n_last = 0;
  double operations = 0;

  [[nodiscard]] const Matrix& L() const { return factor->matrixL().nestedExpression(); }
  void check_pivots(const Matrix& stiffness,
                    const std::function<std::string(Index)>& describe) const;
};

/// Eigen reports success for a singular matrix whose pivots are rounding errors. A pivot is a diagonal entry
/// minus an inner product of as many terms as its row of L is long: that bounds its error. At a pivot
/// that is exactly zero Eigen stops, and what comes after it in L and D was never written.
void ContactLastFactor::Parts::check_pivots(
    const Matrix& stiffness, const std::function<std::string(Index)>& describe) const {
  const Index n = stiffness.cols();
  std::vector<Index> row_length(static_cast<std::size_t>(n), 1);
  if (factor->info() == Eigen::Success)
    for (Index k = 0; k < L().nonZeros(); ++k)
      ++row_length[static_cast<std::size_t>(L().innerIndexPtr()[k])];
  const Permutation to_old = to_new.inverse();
  const Eigen::VectorXd diagonal = stiffness.diagonal();
  for (Index k = 0; k < n; ++k) {
    const Index unknown = to_old.indices()(k);
    const double rounding = std::numeric_limits<double>::epsilon() *
                            static_cast<double>(row_length[static_cast<std::size_t>(k)]) *
                            diagonal(unknown);
    if (pivots(k) > rounding && diagonal(unknown) > 0) continue;
    throw ProblemError(
        text("stiffness matrix is singular at unknown ", unknown,
             describe ? " (" + describe(unknown) + ")" : "", ": pivot ", pivots(k),
             " of a diagonal entry ", diagonal(unknown),
             ". Something can move there without resistance: add a support; or the cells are too "
             "slender for double precision: use more of them"));
  }
}

ContactLastFactor::ContactLastFactor(const Matrix& stiffness, const EliminationOrder& order,
                                     Index n_last, Ledger& ledger,
                                     const std::function<std::string(Index)>& describe)
    : parts_(std::make_unique<Parts>()) {
  const Index n = stiffness.rows();
  require(
      stiffness.cols() == n && static_cast<Index>(order.size()) == n && n_last >= 0 && n_last <= n,
      "ContactLastFactor: need a square matrix and an order of all its unknowns, got ", n, " x ",
      stiffness.cols(), ", ", order.size(), " places and ", n_last, " unknowns last");
  parts_->n_last = n_last;
  Matrix upper;
  {
    const Ledger::Phase phase(ledger, "symbolic");
    parts_->to_new = positions(order);
    upper = reordered(stiffness, parts_->to_new);
    parts_->factor = std::make_unique<Cholesky>();
    parts_->factor->analyzePattern(upper);
  }
  {
    const Ledger::Phase phase(ledger, "numeric");
    parts_->factor->factorize(upper);
    parts_->pivots = parts_->factor->vectorD();
    parts_->check_pivots(stiffness, describe);
    parts_->operations = operation_count(*parts_->factor);
    ledger.count("nonzeros", nonzeros());
    ledger.count("operations", static_cast<long long>(operations()));
    ledger.bytes(nonzeros() * static_cast<long long>(sizeof(double) + sizeof(int)));
  }
}

ContactLastFactor::~ContactLastFactor() = default;
ContactLastFactor::ContactLastFactor(ContactLastFactor&&) noexcept = default;
ContactLastFactor& ContactLastFactor::operator=(ContactLastFactor&&) noexcept = default;

Eigen::VectorXd ContactLastFactor::solve(const Eigen::Ref<const Eigen::VectorXd>& load) const {
  require(load.size() == size(), "ContactLastFactor::solve: load must have ", size(),
          " entries (one per unknown), got ", load.size());
  Eigen::VectorXd x = parts_->to_new * load;
  parts_->factor->matrixL().solveInPlace(x);
  x.array() /= parts_->pivots.array();
  parts_->factor->matrixU().solveInPlace(x);
  return parts_->to_new.transpose() * x;
}

Eigen::MatrixXd ContactLastFactor::compliance(
    const Eigen::SparseMatrix<double, Eigen::RowMajor>& A) const {
  require(A.cols() == size(), "ContactLastFactor::compliance: A must have ", size(),
          " columns (one per unknown), got ", A.cols());
  const Index first = size() - parts_->n_last;
  Eigen::MatrixXd L22 = Eigen::MatrixXd::Identity(parts_->n_last, parts_->n_last);
  for (Index k = first; k < size(); ++k)
    for (Matrix::InnerIterator entry(parts_->L(), k); entry; ++entry)
      if (entry.row() > k) L22(entry.row() - first, k - first) = entry.value();
  Eigen::MatrixXd V = Eigen::MatrixXd::Zero(parts_->n_last, A.rows());
  for (Index pair = 0; pair < A.rows(); ++pair)
    for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator entry(A, pair); entry;
         ++entry) {
      const Index position = parts_->to_new.indices()(entry.col()) - first;
      require(position >= 0, "ContactLastFactor::compliance: row ", pair, " of A uses unknown ",
              entry.col(), ", which was not ordered last");
      V(position, pair) += entry.value();
    }
  L22.triangularView<Eigen::UnitLower>().solveInPlace(V);
  const Eigen::VectorXd scale = parts_->pivots.tail(parts_->n_last).cwiseSqrt().cwiseInverse();
  V = scale.asDiagonal() * V;
  Eigen::MatrixXd G = Eigen::MatrixXd::Zero(A.rows(), A.rows());
  G.selfadjointView<Eigen::Lower>().rankUpdate(V.transpose());
  G.triangularView<Eigen::StrictlyUpper>() = G.transpose();
  return G;
}

Index ContactLastFactor::size() const { return parts_->to_new.size(); }
Index ContactLastFactor::nonzeros() const { return parts_->L().nonZeros() + size(); }
double ContactLastFactor::operations() const { return parts_->operations; }

std::vector<Index> contact_unknowns(const Eigen::SparseMatrix<double, Eigen::RowMajor>& A) {
  std::vector<Index> columns;
  for (Index row = 0; row < A.outerSize(); ++row)
    for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator entry(A, row); entry; ++entry)
      columns.push_back(entry.col());
  std::sort(columns.begin(), columns.end());
  columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
  return columns;
}

}  // namespace signorini

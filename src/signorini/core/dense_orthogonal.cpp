// # Factors that tell the rank
//
// LU and Cholesky need a matrix that can be inverted. Contact has others: rows that say the same
// twice, and bodies that can still move. Four factorisations with orthonormal columns answer what
// is left to ask: which columns are independent, what a matrix takes to zero, which x fits best,
// and how large the matrix is in each direction.

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <utility>

#include "signorini/core/dense.hpp"

namespace signorini {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

// QR with column pivoting takes the longest column first, removes its direction from the others,
// and goes on with the longest of what is left. It stops when nothing is left but rounding. Of the
// columns (1, 0), (2, 0), (0, 1) it takes the second, then the third; the first adds nothing, and
// the rank is 2.
ColumnSpan column_span(const MatrixXd& matrix, double threshold) {
  Eigen::ColPivHouseholderQR<MatrixXd> factor(matrix);
  if (threshold >= 0) factor.setThreshold(threshold);
  ColumnSpan span;
  span.rank = factor.rank();
  const auto& order = factor.colsPermutation().indices();
  span.order.assign(order.data(), order.data() + order.size());
  span.basis = factor.householderQ() * MatrixXd::Identity(matrix.rows(), span.rank);
  return span;
}

// \f$ Ex = 0 \f$ says that x is orthogonal to every row of E. A QR of \f$ E^T \f$ has an
// orthonormal basis of these rows in its first columns; the other columns of Q are orthogonal to
// them all. Pivoting of rows and columns is slower than that of columns alone, and finds the rank
// more surely.
MatrixXd null_space(const MatrixXd& matrix) {
  const Eigen::FullPivHouseholderQR<MatrixXd> factor(matrix.transpose());
  const MatrixXd Q = factor.matrixQ();
  return Q.rightCols(matrix.cols() - factor.rank());
}

namespace {

/// Rows and columns of a matrix that have nothing to do with the others.
struct Block {
  std::vector<Index> rows;
  std::vector<Index> columns;
};

// The blocks that a matrix falls into: columns that have an entry in one row are in one.
// A new column joins all blocks with which it shares a row, and these become one. `owner` says for
// each row in which block it is by now.
std::vector<Block> blocks_of(const MatrixXd& matrix) {
  std::vector<Block> blocks;
  std::vector<Index> owner(static_cast<std::size_t>(matrix.rows()), -1);
  for (Index j = 0; j < matrix.cols(); ++j) {
    Block own{{}, {j}};
    const Index number = static_cast<Index>(blocks.size());
    for (Index i = 0; i < matrix.rows(); ++i) {
      if (matrix(i, j) == 0) continue;
      const Index other = owner[static_cast<std::size_t>(i)];
      if (other == number) continue;
      if (other < 0) own.rows.push_back(i);
      if (other >= 0) {
        Block taken = std::exchange(blocks[static_cast<std::size_t>(other)], {});
        own.columns.insert(own.columns.end(), taken.columns.begin(), taken.columns.end());
        own.rows.insert(own.rows.end(), taken.rows.begin(), taken.rows.end());
        for (const Index row : taken.rows) owner[static_cast<std::size_t>(row)] = number;
      }
      owner[static_cast<std::size_t>(i)] = number;
    }
    blocks.push_back(std::move(own));
  }
  return blocks;
}

}  // namespace

// If A has not full rank, many x fit equally well. We take the shortest, so that the answer is
// defined.
// A matrix of rigid motions has a block per body. One by one they cost as many operations as there are bodies; as one
// matrix, the cube of that.
VectorXd least_norm_solution(const MatrixXd& matrix, const VectorXd& b) {
  VectorXd x = VectorXd::Zero(matrix.cols());
  for (const Block& block : blocks_of(matrix))
    if (!block.rows.empty()) {
      const MatrixXd part = matrix(block.rows, block.columns);
      const VectorXd own =
          Eigen::CompleteOrthogonalDecomposition<MatrixXd>(part).solve(VectorXd(b(block.rows)));
      x(block.columns) = own;
    }
  return x;
}

// If there are many right-hand sides, the matrix that leads from b to this x is worth having.
MatrixXd pseudo_inverse(const MatrixXd& matrix) {
  return Eigen::CompleteOrthogonalDecomposition<MatrixXd>(matrix).pseudoInverse();
}

// \f$ A = U\,\mathrm{diag}(\sigma)\,V^T \f$: the columns of V are directions that stay orthogonal
// under A, \f$ \sigma \f$ says how much each is stretched, and the columns of U say where it goes.
// Jacobi's method is slow and accurate.
SingularValues singular_values(const MatrixXd& matrix) {
  const Eigen::JacobiSVD<MatrixXd> svd(matrix, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

// The signs of the eigenvalues say whether A is definite. The vectors are not computed, which is
// the larger part of the work.
VectorXd symmetric_eigenvalues(const MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace signorini

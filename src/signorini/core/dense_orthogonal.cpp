#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <utility>

#include "signorini/core/dense.hpp"

namespace signorini {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

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

/// The blocks that a matrix falls into: columns that have an entry in one row are in one.
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

MatrixXd pseudo_inverse(const MatrixXd& matrix) {
  return Eigen::CompleteOrthogonalDecomposition<MatrixXd>(matrix).pseudoInverse();
}

SingularValues singular_values(const MatrixXd& matrix) {
  const Eigen::JacobiSVD<MatrixXd> svd(matrix, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

VectorXd symmetric_eigenvalues(const MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace signorini

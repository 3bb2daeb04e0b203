// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The LU factor of matrices whose entries lie almost symmetrically around a large diagonal.
#pragma once
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

namespace signorini {

/// P A Q = L U as SparseLuFactor, of the same matrices one after the other, but that rows and columns have one order, that of minimum
/// degree: other rows come first only where the diagonal entry is less than a tenth of its column. SparseLuFactor must suit any order
/// of the rows, and leaves more entries.
class DiagonalLu {
 public:
  DiagonalLu() { lu_.setPivotThreshold(0.1); }
  /// \param matrix  compressed; the first one decides on the order
  /// \return whether no pivot is zero
  bool factorise(const Eigen::SparseMatrix<double>& matrix) {
    if (!ordered_) lu_.analyzePattern(matrix);
    ordered_ = true;
    lu_.factorize(matrix);
    return lu_.info() == Eigen::Success;
  }
  /// \param b  `n` \return the solution x of A x = b for the last matrix
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return lu_.solve(b); }
  /// \return -1 or 1: the sign of the determinant of the last matrix, if no pivot is zero
  [[nodiscard]] int sign() { return static_cast<int>(lu_.signDeterminant()); }
  /// \return entries of L and U of the last matrix
  [[nodiscard]] Eigen::Index entries() const { return lu_.nnzL() + lu_.nnzU(); }

 private:
  /// SparseLU takes the inverse of the permutation that AMDOrdering returns.
  struct MinimumDegree {
    using PermutationType = Eigen::AMDOrdering<int>::PermutationType;
    void operator()(const Eigen::SparseMatrix<double>& matrix, PermutationType& order) const {
      PermutationType inverse;
      Eigen::AMDOrdering<int>()(matrix, inverse);
      order = inverse.inverse();
    }
  };
  Eigen::SparseLU<Eigen::SparseMatrix<double>, MinimumDegree> lu_;
  bool ordered_ = false;
};

}  // namespace signorini

// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Residuals of many equations at once in about twice the working precision.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "signorini/core/alignment.hpp"

namespace signorini {

/// A vector of running sums, as ExactSum for each entry, that takes whole columns of a matrix.
class ExactVector {
 public:
  /// \param start  what the sums start at
  explicit ExactVector(const Eigen::VectorXd& start)
      : high_(start), low_(Eigen::VectorXd::Zero(start.size())) {}

  /// Adds a column times a factor without rounding the products.
  /// \param column  as long as the vector, magnitudes below 2^996
  /// \param factor  of magnitude below 2^996
  void add_product(const Eigen::Ref<const Eigen::VectorXd>& column, double factor);
  /// Adds a column of a sparse matrix times a factor without rounding the products.
  /// \param matrix  with as many rows as the vector, magnitudes below 2^996
  /// \param column  of the matrix
  /// \param factor  of magnitude below 2^996
  void add_product(const Eigen::SparseMatrix<double>& matrix, Eigen::Index column, double factor);
  /// Adds the transpose of a matrix times a vector without rounding the products.
  /// \param matrix   one column per sum, magnitudes below 2^996
  /// \param factors  one per row, magnitudes below 2^996
  void add_products(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& factors);
  /// Adds a small correction, whose rounding does not matter.
  /// \param correction  as long as the vector
  void add_small(const Eigen::Ref<const Eigen::VectorXd>& correction) { low_ += correction; }
  /// \return the sums, each rounded once
  [[nodiscard]] Eigen::VectorXd value() const { return high_ + low_; }

 private:
  Eigen::VectorXd high_;
  Eigen::VectorXd low_;
};

}  // namespace signorini

/// \file
/// Factor of sparse matrices without symmetry. It is compiled once, in sparse_lu.cpp.
#pragma once
#include <Eigen/SparseCore>
#include <memory>

#include "signorini/core/alignment.hpp"

namespace signorini {

/// P A Q = L U of square matrices A that have their entries in the same places, one after the other.
class SparseLuFactor {
 public:
  SparseLuFactor();
  SparseLuFactor(const SparseLuFactor&) = delete;
  SparseLuFactor& operator=(const SparseLuFactor&) = delete;
  ~SparseLuFactor();

  /// \param matrix  A `n x n`; the first one decides on the order Q of the columns
  /// \return whether no pivot is zero; if one is, solve() must not be called
  [[nodiscard]] bool factorise(const Eigen::SparseMatrix<double>& matrix);
  /// \param b  `n`
  /// \return A^-1 b `n` of the last matrix; rounding can make it useless if A is nearly singular
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  /// \return -1 or 1: the sign of the determinant of the last matrix, if no pivot is zero
  [[nodiscard]] int sign() const;

 private:
  struct Numbers;
  std::unique_ptr<Numbers> numbers_;
};

}  // namespace signorini

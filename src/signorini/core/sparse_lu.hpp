/// \file
/// Factor of sparse matrices without symmetry. It is compiled once, in sparse_lu.cpp.
#pragma once
#include <Eigen/SparseCore>
#include <memory>

#include "signorini/core/alignment.hpp"

namespace signorini {

/// What decides on pivots, and with them on the orders P and Q.
enum class Pivots {
  Largest,  ///< the largest entry of each column: right for any matrix
  Diagonal  ///< the diagonal where it is a tenth of that or more: fewer entries where entries lie almost symmetrically
};

/// P A Q = L U of square matrices A that have their entries in the same places, one after the other.
class SparseLuFactor {
 public:
  /// \param pivots  of all matrices
  explicit SparseLuFactor(Pivots pivots = Pivots::Largest);
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
  /// \return entries of L and U of the last matrix
  [[nodiscard]] Eigen::Index entries() const;

 private:
  struct Numbers;
  std::unique_ptr<Numbers> numbers_;
};

}  // namespace signorini

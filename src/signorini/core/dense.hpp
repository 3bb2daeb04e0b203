/// \file
/// Factors of dense matrices. Each is compiled once, in dense.cpp: this header does without Eigen's solvers.
#pragma once
#include <Eigen/Core>
#include <memory>
#include <vector>

#include "signorini/core/alignment.hpp"

namespace signorini {

/// P A = L U with partial pivoting, of a square matrix A. Copies share the numbers.
class LuFactor {
 public:
  LuFactor() = default;
  /// \param matrix  A `n x n`, n > 0; a singular one is not refused, see pivots() and rcond()
  explicit LuFactor(const Eigen::MatrixXd& matrix);

  /// \param b  `n`
  /// \return A^-1 b `n`; not finite if a pivot is zero
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  /// \param B  `n x k`
  /// \return A^-1 B `n x k`, all columns at once
  [[nodiscard]] Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& B) const;
  /// \return the diagonal of U `n`, signed
  [[nodiscard]] Eigen::VectorXd pivots() const;
  /// \return 1 or -1: the sign of the permutation P, so that det A = sign * product of the pivots
  [[nodiscard]] int permutation_sign() const;
  /// \return an estimate of 1 / (|A| |A^-1|) in the norm of sums of columns; 0 if a pivot is 0
  [[nodiscard]] double rcond() const;

 private:
  struct Numbers;
  std::shared_ptr<const Numbers> numbers_;
};

/// A = L L^T, of a symmetric positive definite matrix A. Copies share the numbers.
class CholeskyFactor {
 public:
  CholeskyFactor() = default;
  /// \param matrix  A `n x n`; only its lower triangle is read
  explicit CholeskyFactor(const Eigen::MatrixXd& matrix);

  /// \return whether all pivots are positive; if not, the factor is of no use
  [[nodiscard]] bool positive() const;
  /// \return L `n x n` in the lower triangle; what stands above it is not part of the factor
  [[nodiscard]] const Eigen::MatrixXd& lower() const;
  /// \param b  `n`
  /// \return A^-1 b `n`
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  /// \param B  `n x k`
  /// \return A^-1 B `n x k`, all columns at once
  [[nodiscard]] Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& B) const;

 private:
  struct Numbers;
  std::shared_ptr<const Numbers> numbers_;
};

/// Solves L X = B in place, all columns at once.
/// \param L  `n x n`; only its lower triangle is read, the diagonal must not vanish
/// \param X  `n x k` B, then X
void solve_lower_columns(const Eigen::Ref<const Eigen::MatrixXd>& L, Eigen::Ref<Eigen::MatrixXd> X);

/// The columns of a matrix in the order in which each adds most to the span of those before it.
struct ColumnSpan {
  Eigen::Index rank = 0;            ///< how many of them are independent
  std::vector<Eigen::Index> order;  ///< all columns, the independent ones first
  Eigen::MatrixXd basis;            ///< `m x rank` orthonormal columns that span the same space
};

/// Finds which columns are independent, by QR with column pivoting.
/// \param matrix     A `m x n`
/// \param threshold  a column adds something if its part outside the span is longer than this times the
///   longest column; negative: epsilon times min(m, n)
/// \return rank, order and basis
[[nodiscard]] ColumnSpan column_span(const Eigen::MatrixXd& matrix, double threshold = -1);

/// \param matrix  E `m x n`
/// \return orthonormal columns that span the x with E x = 0 to rounding, `n x (n - rank)`
[[nodiscard]] Eigen::MatrixXd null_space(const Eigen::MatrixXd& matrix);

/// The shortest of all x with the least |A x - b|.
/// \param matrix  A `m x n`, of any rank
/// \param b       `m`
/// \return x `n`
[[nodiscard]] Eigen::VectorXd least_norm_solution(const Eigen::MatrixXd& matrix,
                                                  const Eigen::VectorXd& b);

/// \param matrix  A `m x n`, of any rank
/// \return A^+ `n x m`, which takes b to its least_norm_solution()
[[nodiscard]] Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix);

/// A = U diag(values) V^T with orthonormal columns in U and V.
struct SingularValues {
  Eigen::MatrixXd U;       ///< `m x min(m, n)`
  Eigen::VectorXd values;  ///< `min(m, n)`, falling, not negative
  Eigen::MatrixXd V;       ///< `n x min(m, n)`
};

/// \param matrix  A `m x n`
/// \return its singular values, also the small ones to the rounding of the largest
[[nodiscard]] SingularValues singular_values(const Eigen::MatrixXd& matrix);

/// \param matrix  `n x n`, n > 0, symmetric; only its lower triangle is read
/// \return its eigenvalues `n`, rising
[[nodiscard]] Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix);

}  // namespace signorini

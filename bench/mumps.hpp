/// \file
/// MUMPS on one process: a plain solve, and the Schur complement that is the compliance of contact.
#pragma once
#include <Eigen/SparseCore>
#include <string>

namespace signorini::bench {

/// \return what to install, or nothing if MUMPS for one process was found
[[nodiscard]] std::string mumps_missing();

/// Ordering, factor and one solve.
/// \param K  `n x n` symmetric positive definite \param p  `n`
/// \return u, not finite if MUMPS reports an error
[[nodiscard]] Eigen::VectorXd mumps_solve(const Eigen::SparseMatrix<double>& K,
                                          const Eigen::VectorXd& p);

/// Ordering and factor of [K Aᵀ; A 0] with the multipliers as Schur variables, whose Schur complement is −A K⁻¹ Aᵀ.
/// \param K  `n x n` symmetric positive definite \param A  `m x n`
/// \return A K⁻¹ Aᵀ `m x m`, not finite if MUMPS reports an error
[[nodiscard]] Eigen::MatrixXd mumps_compliance(
    const Eigen::SparseMatrix<double>& K, const Eigen::SparseMatrix<double, Eigen::RowMajor>& A);

}  // namespace signorini::bench

/// \file
/// Plain solves by the Cholesky factors of others, which ours is measured against.
#pragma once
#include <Eigen/SparseCore>
#include <functional>
#include <string>
#include <vector>

namespace signorini::bench {

/// Ordering, factor and one solve by another library.
struct Yardstick {
  std::string name;  ///< of its class or library
  /// \return u of K u = p [length], not finite if K could not be factored
  std::function<Eigen::VectorXd(const Eigen::SparseMatrix<double>& K, const Eigen::VectorXd& p)>
      solve;
  /// Empty unless it has a way of its own. \return A K^-1 A^T, not finite if K could not be factored
  std::function<Eigen::MatrixXd(const Eigen::SparseMatrix<double>& K,
                                const Eigen::SparseMatrix<double, Eigen::RowMajor>& A)>
      compliance = {};
};

/// \return Eigen's SimplicialLLT, and CHOLMOD's supernodal factor where it was found; both order by
///   approximate minimum degree
[[nodiscard]] std::vector<Yardstick> yardsticks();

/// Without MUMPS, says what to install. \return yardsticks(), and MUMPS, on one process, where it was found
[[nodiscard]] std::vector<Yardstick> all_yardsticks();

/// \return file of the dense kernels that CHOLMOD and MUMPS use in this run, or "none"
[[nodiscard]] std::string dense_kernels();

}  // namespace signorini::bench

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
};

/// \return Eigen's SimplicialLLT, and CHOLMOD's supernodal factor where it was found; both order by
///   approximate minimum degree
[[nodiscard]] std::vector<Yardstick> yardsticks();

}  // namespace signorini::bench

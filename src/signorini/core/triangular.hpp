// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Triangular solves with one right-hand side, for matrices so small that a call costs more than they do.
#pragma once
#include <Eigen/Core>
#include <algorithm>

#include "signorini/core/alignment.hpp"

namespace signorini {

/// Solves L x = b in place, down the columns of L.
/// \param L  `n x k` or larger; only its lower triangle is read, the diagonal must not vanish
/// \param x  `n` b; then x, and behind its first k numbers what these leave of b
inline void solve_lower(const Eigen::Ref<const Eigen::MatrixXd>& L, Eigen::Ref<Eigen::VectorXd> x) {
  const Eigen::Index n = x.size();
  for (Eigen::Index j = 0; j < std::min(n, L.cols()); ++j) {
    x(j) /= L(j, j);
    x.tail(n - j - 1) -= x(j) * L.col(j).segment(j + 1, n - j - 1);
  }
}

/// Solves L^T x = b in place, backwards along the columns of L.
/// \param L  `n x k` or larger; only its lower triangle is read, the diagonal must not vanish
/// \param x  `n` b, then x; known already behind its first k numbers
inline void solve_lower_transposed(const Eigen::Ref<const Eigen::MatrixXd>& L,
                                   Eigen::Ref<Eigen::VectorXd> x) {
  const Eigen::Index k = std::min(x.size(), L.cols());
  const Eigen::Index known = x.size() - k;
  for (Eigen::Index j = 0; j < k && known > 0; ++j)  // along the memory of L
    x(j) -= L.col(j).segment(k, known).dot(x.tail(known));
  for (Eigen::Index j = k - 1; j >= 0; --j)
    x(j) = (x(j) - L.col(j).segment(j + 1, k - j - 1).dot(x.segment(j + 1, k - j - 1))) / L(j, j);
}

}  // namespace signorini

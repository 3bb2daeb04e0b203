/// \file
/// When a refinement ends: the one rule for sparse programmes and dense ones.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "signorini/core/rounding.hpp"

namespace signorini {

/// \param change  a correction \param result  what it corrected
/// \return the largest entry of one over that of the other [-]; 1, all of it, if nothing is left
inline double relative(const Eigen::VectorXd& change, const Eigen::VectorXd& result) {
  const double part = largest(change), whole = largest(result);
  return whole == 0 && part > 0 ? 1 : ratio(part, whole);
}

/// When a sequence of corrections of the relative sizes e_0, e_1, ... ends.
///
/// Errors shrink by the relative error of what was factored, so the rate \f$ \rho_k = \min(1, e_k / \min(1, e_{k-1})) \f$ is
/// about the same for all k, and the next correction will be about \f$ \rho_k e_k \f$. Sweeps end where that is no more
/// than \f$ \epsilon/4 \f$, or where three in a row were not half as large as the smallest before them.
///
/// The first correction may be much larger than what it corrects, where forces out of balance take a body far away. Beside it
/// the next one looks small and is not: so the rate takes no more than 1 for it. And one that is larger than the one before may
/// come between two that shrink, where the factor has hardly a digit: so one alone ends nothing.
///
/// With \f$ e_0 = 10^{-3} \f$ and \f$ e_1 = 10^{-9} \f$ the rate is 1e-6 and the next correction about 1e-15, which still
/// counts. After \f$ e_2 = 10^{-15} \f$ it is 1e-21, and the refinement has ended.
struct Corrections {
  double foreseen = std::numeric_limits<double>::infinity();  ///< \f$ \rho_k e_k \f$ [-]
  double last = std::numeric_limits<double>::infinity();      ///< e_k [-]
  double best = std::numeric_limits<double>::infinity();      ///< the smallest so far [-]
  int slow = 0;  ///< so many in a row were not half of `best`

  /// \param du, u  correction and displacements \param df, f  correction and forces
  /// \return e, the larger share of the two [-]
  static double size(const Eigen::VectorXd& du, const Eigen::VectorXd& u, const Eigen::VectorXd& df,
                     const Eigen::VectorXd& f) {
    return std::max(relative(du, u), relative(df, f));
  }
  /// \param e  of the next correction \return whether it is finite and corrections still shrink
  bool next(double e) {
    foreseen = std::min(1.0, e / std::min(1.0, last)) * e;
    slow = e <= 0.5 * best ? 0 : slow + 1;
    best = std::min(best, e);
    last = e;
    return std::isfinite(e) && slow < 3;
  }
  /// Corrections that shrink no more have failed, unless they are rounding of as many numbers as rows are closed.
  /// \param closed  how many \return whether the next correction would be rounding
  [[nodiscard]] bool settled(std::size_t closed) const {
    return foreseen <= 0.25 * epsilon ||
           (slow >= 3 && last <= epsilon * static_cast<double>(closed + 1));
  }
};

}  // namespace signorini

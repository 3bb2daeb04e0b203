/// \file
/// The linear system of a floating body whose closed pairs are known, on equilibrated data.
#pragma once
#include <Eigen/Core>
#include <utility>
#include <vector>

#include "signorini/closing/closed_pairs.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/problem/floating.hpp"

namespace signorini {

/// A floating problem with pair i scaled by \f$ s_i = 1/\sqrt{G_{ii}} \f$ and mode j by
/// \f$ c_j = 1 / |s R_j| \f$, so that forces, gaps, amplitudes and resultant have one unit.
struct ScaledFloating {
  ScaledProblem contact;            ///< s G s, s d and s
  Eigen::MatrixXd rigid;            ///< `n_c x n_r` s R c [-]
  Eigen::VectorXd resultant;        ///< `n_r` c r [sqrt(energy)]
  Eigen::VectorXd amplitude_scale;  ///< `n_r` c; amplitude = c * scaled amplitude
  Eigen::MatrixXd span;     ///< U `n_c x k`: orthonormal, with the span of the columns of `rigid`
  Eigen::MatrixXd inverse;  ///< `n_r x k` with rigid * inverse = U
};

/// Equilibrates a floating problem.
/// \param problem  G, d, R, r
/// \return the scaled problem; its modes may be dependent, then k < n_r
/// \throws std::invalid_argument as check_problem(), or if R and r do not fit or are not finite
[[nodiscard]] ScaledFloating equilibrate(const FloatingProblem& problem);

/// The compliance of the springs that first hold the modes.
/// \param problem  scaled by equilibrate()
/// \return the trace of G, or 1 if G is zero [-]
[[nodiscard]] double spring_compliance(const ScaledFloating& problem);

/// \f$ \begin{pmatrix} G_{WW} & R_W \\ R_W^T & 0 \end{pmatrix} \f$ for closed pairs W, factored once.
///
/// Adding \f$ \rho R_W P R_W^T \f$ to the first block changes no solution, because R_W^T lambda is
/// given, and makes that block positive definite; the amplitudes follow from the Schur complement.
class BorderedSystem {
 public:
  /// \param problem     scaled by equilibrate(); must live as long as the system
  /// \param candidates  pairs to close, the most certain first; those that repeat others are left out
  BorderedSystem(const ScaledFloating& problem, const std::vector<Eigen::Index>& candidates);

  /// \return W in the order of the rows of the system
  [[nodiscard]] const std::vector<Eigen::Index>& pairs() const { return pairs_; }

  /// Solves G_WW x + R_W y = top, R_W^T x = bottom.
  /// \param top     `|W|` [sqrt(energy)]
  /// \param bottom  `n_r` [sqrt(energy)]
  /// \return x and y; if W leaves a mode free, y has no part in it
  [[nodiscard]] std::pair<Eigen::VectorXd, Eigen::VectorXd> solve(
      const Eigen::VectorXd& top, const Eigen::VectorXd& bottom) const;

 private:
  /// Takes the rows of a block that are independent of those before them. \param block  of the candidates
  /// \param candidates  pairs \param tiny  pivot, relative to the diagonal, that is rounding
  void choose(const Eigen::MatrixXd& block, const std::vector<Eigen::Index>& candidates,
              double tiny);

  std::vector<Eigen::Index> pairs_;
  Eigen::MatrixXd rigid_;   ///< R_W
  Eigen::MatrixXd factor_;  ///< L of G_WW + rho U_W U_W^T
  Eigen::MatrixXd held_;    ///< `n_r x k` orthonormal: the modes that W holds
  Eigen::MatrixXd spread_;  ///< (L L^T)^-1 R_W held
  CholeskyFactor schur_;    ///< of held^T R_W^T spread
  Eigen::MatrixXd spring_;  ///< rho U_W inverse^T, so that spring * r = rho R_W P r
};

}  // namespace signorini

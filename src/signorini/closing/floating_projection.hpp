/// \file
/// A floating problem without what rigid motions do to it: what Newton's methods for it start from.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/closing/bordered_system.hpp"

namespace signorini {

/// gap = d + G f + U b with U^T f = share, where G = P G P and d = P (d + G f) of the problem, with
/// \f$ P = I - U U^T \f$ and forces f = reach * lambda that have the unit of the gaps they make.
struct FloatingProjection {
  /// \param problem  scaled by equilibrate()
  explicit FloatingProjection(const ScaledFloating& problem);

  /// The amplitudes that a point stands for.
  /// \param problem  the same
  /// \param force    f `n_c`
  /// \param motion   b `k`
  /// \return a `n_r`, scaled
  [[nodiscard]] Eigen::VectorXd amplitude(const ScaledFloating& problem,
                                          const Eigen::VectorXd& force,
                                          const Eigen::VectorXd& motion) const;

  Eigen::MatrixXd G;      ///< `n_c x n_c`, over reach
  Eigen::MatrixXd U;      ///< `n_c x k` orthonormal
  Eigen::VectorXd d;      ///< `n_c`
  Eigen::VectorXd start;  ///< f `n_c`, the least forces in balance
  Eigen::VectorXd share;  ///< `k`
  double reach = 1;       ///< the largest row sum of |P G P|
};

/// Forces in balance, a rigid motion and the gaps that follow from them.
struct FloatingPoint {
  Eigen::VectorXd force;     ///< f `n_c`
  Eigen::VectorXd motion;    ///< b `k`
  Eigen::VectorXd gap;       ///< `n_c`
  Eigen::VectorXd residual;  ///< fischer_burmeister(gap, f) `n_c`
  double merit = 0;          ///< half of its square
};

/// Computes gaps and residual from force and motion.
/// \param problem  projected
/// \param point    complete but for gap, residual and merit
void evaluate(const FloatingProjection& problem, FloatingPoint& point);

/// \param problem  projected
/// \return the least forces in balance and the motion of least gaps
[[nodiscard]] FloatingPoint first_point(const FloatingProjection& problem);

/// \param point  evaluated
/// \return pairs whose force exceeds their gap, the clearest first
[[nodiscard]] std::vector<Eigen::Index> closed_pairs(const FloatingPoint& point);

}  // namespace signorini

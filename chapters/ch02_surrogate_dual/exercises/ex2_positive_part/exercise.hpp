/// \file
/// Exercise 2.2 - pressing, not pulling. Do not change this file.
#pragma once
#include <Eigen/Core>

namespace ex2_2 {

/// The best total force for given weights, and what it gains.
struct Gain {
  double force;   ///< eta >= 0 [force]; the smallest one if several are best
  double energy;  ///< s >= 0 [force*length]
};

/// The largest \f$ \eta\, b^T\xi - \tfrac12\eta^2\, \xi^T G\xi \f$ over \f$ \eta \ge 0 \f$, with
/// b = -d: \PaperEq{XuanLi2002, 23} and \PaperEq{XuanLi2002, 24} for all weights, also those that their
/// condition \f$ \eta \ge 0 \f$ excludes.
/// \param compliance  G `n_c x n_c`, symmetric positive semidefinite [length/force]; what is zero is
///                    exactly zero here
/// \param free_gap    d `n_c` [length]: the gap without contact, overlap < 0
/// \param weights     xi `n_c` >= 0
/// \return force and energy, both infinite if the energy has no bound
[[nodiscard]] Gain dual_energy(const Eigen::MatrixXd& compliance, const Eigen::VectorXd& free_gap,
                               const Eigen::VectorXd& weights);

}  // namespace ex2_2

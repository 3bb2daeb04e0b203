/// \file
/// Exercise 8.2 - one pair with friction. Do not change this file.
#pragma once
#include <Eigen/Core>

namespace ex8_2 {

/// One pair: gap = free_gap + normal_compliance * f_n + coupling * f_t,
/// slip = free_slip + coupling * f_n + tangential_compliance * f_t.
struct Pair {
  double free_gap;               ///< d [length], overlap < 0
  double free_slip;              ///< s [length], of the source along the tangent
  double normal_compliance;      ///< G_n > 0 [length/force]
  double tangential_compliance;  ///< G_t > 0 [length/force]
  double mu;                     ///< friction coefficient >= 0
  double cohesion;               ///< c >= 0 [force], where G_n f_n > gap only
  double coupling = 0;           ///< H [length/force] of normal and tangent, H^2 < G_n G_t
};

/// Residuals and their derivatives.
struct System {
  Eigen::Vector4d residual;  ///< [length]
  Eigen::Matrix4d jacobian;  ///< by f_n, f_t [length/force] and u+, u- [-]
};

/// The equations of the pair with the Fischer-Burmeister function, in this order:
/// gap against G_n f_n; slip - u+ + u- \PaperEq{LinEtAl, 19}; u- against G_t (B - f_t)
/// \PaperEq{LinEtAl, 17}; u+ against G_t (B + f_t) \PaperEq{LinEtAl, 18}; with B = c + mu f_n.
/// \param pair      data
/// \param unknowns  f_n, f_t [force], u+, u- [length]
/// \return residuals and Jacobian; fischer_burmeister_slope() gives the slopes
[[nodiscard]] System equations(const Pair& pair, const Eigen::Vector4d& unknowns);

}  // namespace ex8_2

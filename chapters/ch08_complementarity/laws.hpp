/// \file
/// The laws of section 2.1 of the second paper as they stand: gap, normal stress, friction.
#pragma once
#include <Eigen/Core>

namespace signorini {

/// A point of body a and the place of body b that it faces.
struct FacingPoints {
  Eigen::Vector2d x_a, x_b;  ///< before loading [length]
  Eigen::Vector2d u_a, u_b;  ///< displacements [length]
  Eigen::Vector2d n_b;       ///< unit normal out of b
};

/// \param at  two points \return their gap; open > 0 [length]. \PaperEq{LinEtAl, 1}
inline double gap_of(const FacingPoints& at) {
  return (at.x_a - at.x_b).dot(at.n_b) + (at.u_a - at.u_b).dot(at.n_b);
}

/// What a pair does along its normal.
enum class NormalCase { Apart, Pressed, Touching, Forbidden };

/// \PaperEq{LinEtAl, 2} to \PaperEq{LinEtAl, 4}, which together are \PaperEq{LinEtAl, 11}
/// \param gap      [length] \param sigma_n  normal stress, tension > 0 [force/length^2]
/// \return which of the three cases holds, or that none does
inline NormalCase normal_case(double gap, double sigma_n) {
  if (gap > 0 && sigma_n == 0) return NormalCase::Apart;
  if (gap == 0 && sigma_n < 0) return NormalCase::Pressed;
  return gap == 0 && sigma_n == 0 ? NormalCase::Touching : NormalCase::Forbidden;
}

/// \param c  cohesion \param mu  friction coefficient \param sigma_n  tension > 0
/// \return the right side of (6) and (8): what the shear may be at most. \PaperEq{LinEtAl, 6}
inline double shear_bound(double c, double mu, double sigma_n) { return c - mu * sigma_n; }

/// What a pair does along its tangent.
enum class TangentialCase { Sticks, Slides, Forbidden };

/// \PaperEq{LinEtAl, 8} to \PaperEq{LinEtAl, 10}, for magnitudes
/// \param shear  magnitude \param slid  distance, not negative \param bound  of the shear
/// \return which case holds, or that none does
inline TangentialCase tangential_case(double shear, double slid, double bound) {
  if (shear > bound || slid < 0) return TangentialCase::Forbidden;             // (8)
  if (slid == 0) return TangentialCase::Sticks;                                // (9)
  return shear == bound ? TangentialCase::Slides : TangentialCase::Forbidden;  // (10)
}

/// \PaperEq{LinEtAl, 13} where the shear on a is not negative, \PaperEq{LinEtAl, 14} where it is not positive
/// \param shear  on a, along t \param slip  of a, along t \param bound  of the shear
/// \return whether the law with signs holds
inline bool coulomb_holds(double shear, double slip, double bound) {
  const bool first = shear >= 0 && shear <= bound && slip <= 0 && (bound - shear) * slip == 0;
  const bool second = shear <= 0 && -shear <= bound && slip >= 0 && (bound + shear) * slip == 0;
  return first || second;
}

/// \PaperEq{LinEtAl, 15} \PaperEq{LinEtAl, 16}
/// \param shear  on a, along t \param plus  part of the slip \param minus  the other part \param bound  of the shear
/// \return whether the law in two parts holds
inline bool split_holds(double shear, double plus, double minus, double bound) {
  const bool back = bound - shear >= 0 && minus >= 0 && (bound - shear) * minus == 0;  // (15)
  const bool forth = bound + shear >= 0 && plus >= 0 && (bound + shear) * plus == 0;   // (16)
  return back && forth;
}

}  // namespace signorini

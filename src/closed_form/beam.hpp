/// \file
/// A cantilever beam under uniform load that comes to lie on a flat rigid foundation: two theories.
#pragma once

namespace signorini {

/// A cantilever of rectangular section above a foundation; positive numbers but for nu and q.
struct BeamOnFoundation {
  double length;          ///< l [length]
  double height;          ///< h [length]
  double width;           ///< b, across the plane [length]
  double youngs_modulus;  ///< E [force/length^2]
  double poisson_ratio;   ///< nu [-], above -1; used by the shear stiffness only
  double gap;             ///< g, initial distance from the foundation [length]
  double pressure;        ///< q on the upper face [force/length^2], not negative
};

/// Where and how hard a beam touches.
struct BeamContact {
  double touchdown;  ///< distance from the clamp to where contact begins [length]; `length` if only
                     ///< the tip touches or nothing does
  double total_force;  ///< of the foundation on the beam [force], upwards, 0 if nothing touches
  double
      point_force;  ///< the part of it that acts in one point: at the touchdown (Euler-Bernoulli),
                    ///< at the tip (Timoshenko, or tip contact) [force]
};

/// Load at which the tip first touches, Euler-Bernoulli: \f$ 8 E I g / (b l^4) \f$.
/// \param beam  whose pressure does not enter
/// \return pressure on the upper face [force/length^2]
/// \throws std::invalid_argument if a length, the modulus or the gap is not positive, or the
///   pressure is negative
[[nodiscard]] double tip_contact_pressure(const BeamOnFoundation& beam);
/// Load at which contact spreads from the tip, Euler-Bernoulli: \f$ 72 E I g / (b l^4) \f$.
/// \param beam  whose pressure does not enter
/// \return pressure on the upper face [force/length^2]
/// \throws std::invalid_argument as tip_contact_pressure()
[[nodiscard]] double line_contact_pressure(const BeamOnFoundation& beam);

/// Euler-Bernoulli: sections stay normal to the axis.
///
/// In line contact the beam is tangent to the foundation without moment at
/// \f$ s = (72 E I g / w)^{1/4},\ w = q b \f$, bears a point force \f$ w s / 3 \f$ there and the
/// load itself beyond. If only the tip touches, it bears \f$ 3 w l / 8 - 3 E I g / l^3 \f$.
/// \param beam  with its load
/// \return where and how hard it touches
/// \throws std::invalid_argument as tip_contact_pressure()
[[nodiscard]] BeamContact euler_bernoulli(const BeamOnFoundation& beam);

/// Timoshenko: sections may shear, with the shear area \f$ \kappa A = 5/6\, b h \f$.
///
/// A beam that may shear bears no point force at s; beyond s its rotation satisfies
/// \f$ \theta'' = \theta / \lambda^2,\ \lambda^2 = E I / (\kappa G A) \f$, and a point force stays
/// at the tip. s is the root of the one condition left, found by bisection to rounding.
/// \param beam  with its load
/// \return where and how hard it touches
/// \throws std::invalid_argument as tip_contact_pressure()
[[nodiscard]] BeamContact timoshenko(const BeamOnFoundation& beam);

/// Contact pressure of the Timoshenko beam, without the point force T that stays at the tip.
///
/// Beyond the touch-down \f$ p = q + T / (b \lambda)\, \sinh((l - x) / \lambda) \f$.
/// \param beam  as for timoshenko()
/// \param x     distance from the clamp [length], at most `beam.length`
/// \return pressure [force/length^2]; 0 before the touch-down, and everywhere without line contact
/// \throws std::invalid_argument as tip_contact_pressure()
[[nodiscard]] double timoshenko_pressure(const BeamOnFoundation& beam, double x);

}  // namespace signorini

/// \file
/// A cantilever beam under uniform load that comes to lie on a flat rigid foundation: two beam theories.
#pragma once

namespace signorini {

/// A cantilever of rectangular section above a foundation.
struct BeamOnFoundation {
  double length;          ///< l [length]
  double height;          ///< h [length]
  double width;           ///< across the plane [length]
  double youngs_modulus;  ///< E [force/length^2]
  double poisson_ratio;   ///< nu [-]; used by the shear stiffness only
  double gap;             ///< initial distance from the foundation [length]
  double pressure;        ///< q on the upper face [force/length^2]
};

/// Where and how hard a beam touches.
struct BeamContact {
  double
      touchdown;  ///< distance from the clamp at which contact begins [length]; `length` if only the
                  ///< tip touches or nothing does
  double total_force;  ///< of the foundation on the beam [force]
};

/// Load at which the tip first touches, 8 E I g / (b l^4), Euler-Bernoulli [force/length^2].
[[nodiscard]] double tip_contact_pressure(const BeamOnFoundation& beam);
/// Load at which contact begins to spread from the tip, 72 E I g / (b l^4), Euler-Bernoulli [force/length^2].
[[nodiscard]] double line_contact_pressure(const BeamOnFoundation& beam);

/// Euler-Bernoulli: sections stay normal to the axis.
///
/// In line contact the beam is tangent to the foundation without moment at s = (72 E I g / w)^(1/4), w = q b,
/// bears a point force w s / 3 there and the load itself beyond.
[[nodiscard]] BeamContact euler_bernoulli(const BeamOnFoundation& beam);

/// Timoshenko: sections may shear, with the shear area 5/6 b h.
///
/// In contact no point force at s is possible; the rotation satisfies theta'' = theta / lambda^2 with
/// lambda^2 = E I / (kappa G A), and a point force stays at the tip. s is the root of the one condition
/// left, found by bisection to rounding.
[[nodiscard]] BeamContact timoshenko(const BeamOnFoundation& beam);

/// Contact pressure of the Timoshenko beam, without the point force that stays at the tip.
///
/// p = q + T / (b lambda) sinh((l - x) / lambda) beyond the touch-down, with T the tip force.
/// \param beam  as for timoshenko()
/// \param x     distance from the clamp [length]
/// \return pressure [force/length^2], 0 before the touch-down
[[nodiscard]] double timoshenko_pressure(const BeamOnFoundation& beam, double x);

}  // namespace signorini

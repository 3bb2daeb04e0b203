/// \file
/// A rigid strip on a half-plane, and numbers of plates that bend.
///
/// x is measured from the middle of the strip, depth below the surface; forces are per thickness.
#pragma once
#include <Eigen/Core>

#include "signorini/core/alignment.hpp"

namespace signorini {

/// A rigid strip that is pressed down without friction.
struct RigidStrip {
  double half_width;        ///< a [length], > 0
  double force;             ///< P [force/length], > 0; 2 q a under the pressure q
  double eccentricity = 0;  ///< e of the load, towards positive x [length], at most a/2 either way
};

/// Pressure below a rigid strip, \PaperEq{LinEtAl, 46} with P = 2 q a [\ref Johnson1985]:
/// \f[ p = \frac{P}{\pi \sqrt{a^2 - x^2}} \Big(1 + \frac{2 e x}{a^2}\Big). \f]
///
/// It is infinite at the edges. With |e| > a/2 it would be negative at one of them: the strip lifts
/// off, and this is no longer the solution.
/// \param strip  with its load
/// \param x      [length]
/// \return pressure [force/length^2], compression > 0; 0 beside the strip
/// \throws std::invalid_argument unless a and P are positive and |e| <= a/2
[[nodiscard]] double rigid_strip_pressure(const RigidStrip& strip, double x);

/// Force that a rigid strip passes on between two points: what a node with its share can be
/// compared with, at the edges too.
/// \f[ \frac{P}{\pi}\Big[\arcsin\frac{x}{a} - \frac{2 e}{a^2}\sqrt{a^2 - x^2}\Big]_{x_1}^{x_2} \f]
/// \param strip  with its load
/// \param from   x_1 [length]
/// \param to     x_2 [length]; parts beside the strip count nothing
/// \return force [force/length], compression > 0, negative if the points are exchanged
/// \throws std::invalid_argument as rigid_strip_pressure()
[[nodiscard]] double rigid_strip_force(const RigidStrip& strip, double from, double to);

/// Rotation of a rigid strip by an eccentric load: \f$ 4 P e / (\pi E^{*} a^2) \f$.
/// \param strip    with its load
/// \param modulus  E* of the half-plane, plane_strain_modulus() or E [force/length^2], > 0
/// \return angle [rad], > 0 if the side of positive x goes down
/// \throws std::invalid_argument as rigid_strip_pressure(), or unless the modulus is positive
[[nodiscard]] double rigid_strip_rotation(const RigidStrip& strip, double modulus);

/// Stress below a rigid strip.
///
/// With \f$ w = x - i z \f$ and \f$ Z = -P (1 + 2 e w / a^2) / (\pi \sqrt{a^2 - w^2}) \f$,
/// \f[ \sigma_x = \mathrm{Re}\,Z + z\,\mathrm{Im}\,Z',\quad
///     \sigma_y = \mathrm{Re}\,Z - z\,\mathrm{Im}\,Z',\quad \tau_{xy} = z\,\mathrm{Re}\,Z' \f]
/// with y out of the half-plane. Below the middle of a central load
/// \f$ \sigma_y = -P (a^2 + 2 z^2) / (\pi (a^2 + z^2)^{3/2}) \f$.
/// \param strip  with its load
/// \param x      [length]
/// \param depth  z [length], not negative; on the surface not at an edge
/// \return (xx, yy, xy) [force/length^2], tension > 0
/// \throws std::invalid_argument as rigid_strip_pressure(), if the depth is negative, or at an edge
[[nodiscard]] Eigen::Vector3d rigid_strip_stress(const RigidStrip& strip, double x, double depth);

/// Pressure below the middle of an elastic plate that lies smoothly on a half-plane.
struct FlexibleStrip {
  double softness;  ///< rho = E* a^3 / D [-], D = E t^3 / (12 (1 - nu^2)) of a plate of thickness t
  double pressure;  ///< p(0) / q under the uniform pressure q on the whole plate [-]
};

/// Plates from rigid to flexible; at rho = 0 the rigid strip, 2 / pi. There is no closed form between:
/// these are numbers of an integral equation, rounded to four digits.
inline constexpr FlexibleStrip flexible_strips[] = {
    {0, 0.6366}, {0.1, 0.6397}, {1, 0.6653}, {10, 0.8195}, {100, 1.0091}};

}  // namespace signorini

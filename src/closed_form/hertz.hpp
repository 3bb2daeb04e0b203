/// \file
/// Two cylinders pressed together along a line, without friction: the theory of Hertz.
///
/// Formulas as in Johnson [\ref Johnson1985], chapter 4. The surface is a half-plane as long as the
/// contact is short against the radius; forces are per thickness.
#pragma once
#include <Eigen/Core>

#include "signorini/core/alignment.hpp"

namespace signorini {

/// Two cylinders, or a cylinder and a plate, pressed together along a line.
struct LineContact {
  double radius;   ///< R, 1/R = 1/R_1 + 1/R_2; a plate has 1/R_2 = 0 [length], > 0
  double modulus;  ///< E* as contact_modulus() [force/length^2], > 0
  double force;    ///< P [force/length], > 0
};

/// Half of the contact's width, \PaperEq{LinEtAl, 43} first line:
/// \f$ b = \sqrt{4 P R / (\pi E^{*})} \f$.
///
/// In the paper E / (2 (1 - nu^2)) stands for E*: two bodies of one material.
/// \param contact  with its load
/// \return b [length]
/// \throws std::invalid_argument unless radius, modulus and force are positive
[[nodiscard]] double hertz_half_width(const LineContact& contact);

/// Largest pressure, \PaperEq{LinEtAl, 43} second line: \f$ q_0 = \sqrt{P E^{*} / (\pi R)} \f$.
/// \param contact  with its load
/// \return q_0 in the middle of the contact [force/length^2], compression > 0
/// \throws std::invalid_argument as hertz_half_width()
[[nodiscard]] double hertz_peak_pressure(const LineContact& contact);

/// Contact pressure \f$ q_0 \sqrt{1 - x^2 / b^2} \f$.
/// \param contact  with its load
/// \param x        from the middle of the contact [length]
/// \return pressure [force/length^2], compression > 0, 0 outside of the contact
/// \throws std::invalid_argument as hertz_half_width()
[[nodiscard]] double hertz_pressure(const LineContact& contact, double x);

/// Stress below the surface of either body: the formulas of M'Ewen [\ref MEwen1949].
///
/// With \f$ s = b^2 - x^2 + z^2,\ r = \sqrt{s^2 + 4 x^2 z^2} \f$ and
/// \f$ m^2 = (r + s)/2,\ n^2 = (r - s)/2 \f$, n with the sign of x,
/// \f[ \sigma_x = -\frac{q_0}{b}\Big[m\Big(1 + \frac{z^2 + n^2}{m^2 + n^2}\Big) - 2 z\Big],\quad
///     \sigma_y = -\frac{q_0}{b}\,m\Big(1 - \frac{z^2 + n^2}{m^2 + n^2}\Big),\quad
///     \tau_{xy} = \frac{q_0}{b}\,n\,\frac{m^2 - z^2}{m^2 + n^2}. \f]
/// The axes are x along the surface and y out of the body, which is where books that count y or z
/// into the body have the other sign of the shear.
/// \param contact  with its load
/// \param x        from the middle of the contact [length]
/// \param depth    z below the surface [length], not negative
/// \return (xx, yy, xy) [force/length^2], tension > 0
/// \throws std::invalid_argument as hertz_half_width(), or if the depth is negative
[[nodiscard]] Eigen::Vector3d hertz_stress(const LineContact& contact, double x, double depth);

/// The largest shear stress of the plane, and where it is.
struct LargestShear {
  double depth;   ///< below the middle of the contact [length]
  double stress;  ///< half of the difference of the principal stresses there [force/length^2]
};

/// Largest shear of the plane.
///
/// On the axis it is \f$ q_0 (\zeta - \zeta^2 / \sqrt{1 + \zeta^2}),\ \zeta = z / b \f$. With
/// \f$ s = \zeta / \sqrt{1 + \zeta^2} \f$ the derivative vanishes where 1 - 2 s + s^3 = 0, so that
/// s is the golden ratio \f$ \phi = (\sqrt 5 - 1) / 2 \f$, the depth \f$ b \sqrt\phi = 0.786\,b \f$ and
/// the stress \f$ q_0\,\phi^{5/2} = 0.3003\,q_0 \f$.
/// \param contact  with its load
/// \return depth and stress
/// \throws std::invalid_argument as hertz_half_width()
[[nodiscard]] LargestShear hertz_largest_shear(const LineContact& contact);

/// How far the centre of a disc moves towards its contact, if the same force acts across it on the
/// other end of the diameter: \f$ P\,[2 \ln(4 R / b) - 1] / (\pi E') \f$, up to terms of (b/R)^2.
/// \param contact  with its load
/// \param modulus  E' of the disc [force/length^2]
/// \param radius   of the disc, R [length], which differs from that of the contact if the other
///   body is curved as well
/// \return approach [length]
/// \throws std::invalid_argument as hertz_half_width(), or unless modulus and radius are positive
[[nodiscard]] double disc_approach(const LineContact& contact, double modulus, double radius);

}  // namespace signorini

/// \file
/// A disc squeezed between two elastic plates: the pressure of Hertz in place of the line loads.
///
/// The load acts along y on the points (0, R) and (0, -R) as in brazilian.hpp; stresses are
/// tension > 0, forces per thickness.
#pragma once
#include <Eigen/Core>

#include "closed_form/brazilian.hpp"
#include "closed_form/hertz.hpp"

namespace signorini {

/// Stress on the loaded diameter of a disc between two elastic plates, closed form.
///
/// Near its contact the load is the pressure of Hertz on a half-plane, and the other load is far
/// away, a line:
/// \f[ \sigma_x = \frac{P}{\pi R} + \sigma_x^{\mathrm{Hertz}}(z),\quad
///     \sigma_y = \frac{P}{\pi R} + \sigma_y^{\mathrm{Hertz}}(z) - \frac{2 P}{\pi (2 R - z)}. \f]
/// The plane in place of the arc costs terms of b/R: in the disc of the paper \f$ \sigma_x \f$ is too
/// large by 1.5 % of P / (pi R) at z = 2 b, by 0.4 % at 3 b, against plate_loaded_disc_stress().
/// \param plate  contact of one plate with the disc, with P
/// \param disc   R of the disc, equal to that of the contact if the plate is flat [length], > 0
/// \param depth  z below the contact [length], from 0 to the centre at R
/// \return (xx, yy, 0) [force/length^2]
/// \throws std::invalid_argument as hertz_stress(), or unless 0 <= depth <= R
[[nodiscard]] Eigen::Vector3d loaded_diameter_stress(const LineContact& plate, double disc,
                                                     double depth);

/// Where the stress across the loaded diameter turns from compression to tension: the zero of the
/// first component of loaded_diameter_stress(), by bisection to rounding.
///
/// Far below the contact Hertz' stress across is \f$ -q_0 b^3 / (4 z^3) \f$, which gives the
/// estimate \f$ z = (R b^2 / 2)^{1/3} \f$.
/// \param plate  contact of one plate with the disc, with P
/// \param disc   R of the disc [length], > 0
/// \return depth below the contact [length]
/// \throws std::invalid_argument as hertz_stress(), or if even the centre of the disc is compressed
[[nodiscard]] double tension_depth(const LineContact& plate, double disc);

/// Stress at any point of a disc between two elastic plates: the pressure of Hertz on its arcs, along
/// y as flat plates press, as a sum of line_loaded_disc_stress() on chords.
///
/// Gauss' rule for the weight \f$ \sqrt{1 - t^2} \f$ at \f$ t_k = \cos(k \pi / (n + 1)) \f$, with n so
/// large that the sum is exact to rounding: its error falls like \f$ e^{-2 n d} \f$, d b being the
/// distance of the point from the loaded arcs.
/// \param plate  contact of one plate with the disc, with P
/// \param disc   R of the disc [length], > b
/// \param x      from the centre [length]
/// \param y      along the load, from the centre [length]
/// \return (xx, yy, xy) [force/length^2]
/// \throws std::invalid_argument as hertz_stress() and line_loaded_disc_stress(), or if the point
///   is nearer than b/100 to a loaded arc
[[nodiscard]] Eigen::Vector3d plate_loaded_disc_stress(const LineContact& plate, double disc,
                                                       double x, double y);

}  // namespace signorini

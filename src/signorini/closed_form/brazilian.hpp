/// \file
/// A disc squeezed across its diameter: by two lines, by two arcs, by two plates.
///
/// The load acts along y on the points (0, R) and (0, -R). Stress is that of thin and of long discs
/// alike, and forces are per thickness; stresses are tension > 0.
#pragma once
#include <Eigen/Core>

#include "signorini/closed_form/hertz.hpp"

namespace signorini {

/// A disc between two opposite forces.
struct SqueezedDisc {
  double radius;  ///< R [length], > 0
  double force;   ///< P, pressing inwards at both ends [force/length], > 0
};

/// Tensile strength by the Brazilian test, \PaperEq{LinEtAl, 44}: \f$ 2 P / (\pi d) \f$ with d = 2 R.
/// \param disc  whose force breaks it
/// \return the tension across the loaded diameter under two line loads [force/length^2]
/// \throws std::invalid_argument unless radius and force are positive
[[nodiscard]] double brazilian_strength(const SqueezedDisc& disc);

/// Stress under two line loads, \PaperEq{LinEtAl, 45} [\ref TimoshenkoGoodier1970].
///
/// With the distances r_1, r_2 from the loads at (0, R) and (0, -R) and the angles theta_1, theta_2 at
/// which they see the point, from the loaded diameter to either side,
/// \f[ \sigma_x = \frac{P}{\pi R} - \frac{2 P}{\pi} \sum_i \frac{\sin^2\theta_i \cos\theta_i}{r_i},\quad
///     \sigma_y = \frac{P}{\pi R} - \frac{2 P}{\pi} \sum_i \frac{\cos^3\theta_i}{r_i},\quad
///     \tau_{xy} = \frac{2 P}{\pi} \Big(\frac{\sin\theta_1 \cos^2\theta_1}{r_1} -
///                 \frac{\sin\theta_2 \cos^2\theta_2}{r_2}\Big), \f]
/// each the field of a line load on a half-plane, and a uniform tension that frees the rim. The
/// paper prints the same with compression > 0.
/// \param disc  with its load
/// \param x     across the loaded diameter, from the centre [length]
/// \param y     along it [length]
/// \return (xx, yy, xy) [force/length^2]
/// \throws std::invalid_argument as brazilian_strength(), or if the point is outside of the disc or
///   under a load
[[nodiscard]] Eigen::Vector3d line_loaded_disc_stress(const SqueezedDisc& disc, double x, double y);

/// Stress if each load is a uniform pressure on the arc 2 alpha about its point: Hondros
/// [\ref Hondros1959], whose series in powers of (r/R)^2 is summed here.
///
/// With rho = r/R, theta from the y axis and \f$ w_\pm = \rho^2 e^{2 i (\alpha \pm \theta)} \f$,
/// \f[ \sigma_{r,\theta} = -\frac{2 p}{\pi} \Big[\alpha \pm \frac{1 - \rho^2}{2}\,\mathrm{Im} \Big(
///     \frac{e^{2 i (\alpha + \theta)}}{1 - w_+} + \frac{e^{2 i (\alpha - \theta)}}{1 - w_-}\Big) -
///     \frac12 \big(\arg(1 - w_+) + \arg(1 - w_-)\big)\Big], \f]
/// \f[ \tau_{r\theta} = \frac{p}{\pi} (1 - \rho^2)\,\mathrm{Re} \Big(
///     \frac{e^{2 i (\alpha - \theta)}}{1 - w_-} - \frac{e^{2 i (\alpha + \theta)}}{1 - w_+}\Big). \f]
/// The pressure is \f$ p = P / (2 R \sin\alpha) \f$, so that P is the resultant along y; where it is
/// written P / (2 R alpha), stresses differ by alpha^2 / 6.
/// \param disc        with its load
/// \param half_angle  alpha [rad], in (0, pi/2]
/// \param x           across the loaded diameter, from the centre [length]
/// \param y           along it [length]
/// \return (xx, yy, xy) [force/length^2]
/// \throws std::invalid_argument as brazilian_strength(), or if the angle is out of range or the
///   point not inside of the disc
[[nodiscard]] Eigen::Vector3d arc_loaded_disc_stress(const SqueezedDisc& disc, double half_angle,
                                                     double x, double y);

/// Stress on the loaded diameter of a disc between two elastic plates.
///
/// Near its contact the load is the pressure of Hertz, and the other load is far away, a line:
/// \f[ \sigma_x = \frac{P}{\pi R} + \sigma_x^{\mathrm{Hertz}}(z),\quad
///     \sigma_y = \frac{P}{\pi R} + \sigma_y^{\mathrm{Hertz}}(z) - \frac{2 P}{\pi (2 R - z)}. \f]
/// The pressure is taken to act along the axis. Were it normal to the round rim, which is a matter of
/// b/R, \f$ \sigma_x \f$ of the paper's disc would differ by 0.6 % of q_0 at z = b/2 and by less than
/// 0.01 of P / (pi R) from z = 3 b on.
/// \param plate  contact of one plate with the disc, with P
/// \param disc   R of the disc, equal to that of the contact if the plate is flat [length], > 0
/// \param depth  z below the contact [length], from 0 to the centre at R
/// \return (xx, yy, 0) [force/length^2]
/// \throws std::invalid_argument as hertz_stress(), or unless 0 <= depth <= R
[[nodiscard]] Eigen::Vector3d plate_loaded_disc_stress(const LineContact& plate, double disc,
                                                       double depth);

/// Where the stress across the loaded diameter turns from compression to tension: the zero of the
/// first component of plate_loaded_disc_stress(), by bisection to rounding.
///
/// Far below the contact Hertz' stress across is \f$ -q_0 b^3 / (4 z^3) \f$, which gives the estimate
/// \f$ z = (R b^2 / 2)^{1/3} \f$.
/// \param plate  contact of one plate with the disc, with P
/// \param disc   R of the disc [length], > 0
/// \return depth below the contact [length]
/// \throws std::invalid_argument as hertz_stress(), or if even the centre of the disc is compressed
[[nodiscard]] double tension_depth(const LineContact& plate, double disc);

}  // namespace signorini

/// \file
/// A disc squeezed across its diameter by two lines or two arcs.
///
/// The load acts along y on the points (0, R) and (0, -R). Stress is that of thin and of long discs
/// alike, and forces are per thickness; stresses are tension > 0.
#pragma once
#include <Eigen/Core>

#include "signorini/core/alignment.hpp"

namespace signorini {

/// A disc between two opposite forces.
struct SqueezedDisc {
  double radius;  ///< R [length], > 0
  double force;   ///< P, pressing inwards at both ends [force/length], > 0
};

/// Tensile strength by the Brazilian test, \PaperEq{LinEtAl, 44}: \f$ 2 P / (\pi d) \f$ with d = 2 R.
/// The paper has a minus before it, with tension < 0.
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
/// paper has tension < 0, and a plus in the shear, which is right for angles in one sense of rotation.
///
/// Loads on a chord, at \f$ (x_0, \pm\sqrt{R^2 - x_0^2}) \f$, leave on the rim the pressure
/// \f$ P \cos\alpha / (\pi R),\ R \sin\alpha = x_0 \f$, equal everywhere since a chord is seen from all points
/// of a circle at one angle: the uniform tension is then \f$ P \cos\alpha / (\pi R) \f$.
/// \param disc    with its load
/// \param x       across the loads, from the centre [length]
/// \param y       along them [length]
/// \param offset  x_0 of the chord [length], inside of the disc
/// \return (xx, yy, xy) [force/length^2]
/// \throws std::invalid_argument as brazilian_strength(), or if the point or the chord is outside of the disc or
///   the point under a load
[[nodiscard]] Eigen::Vector3d line_loaded_disc_stress(const SqueezedDisc& disc, double x, double y,
                                                      double offset = 0);

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

}  // namespace signorini

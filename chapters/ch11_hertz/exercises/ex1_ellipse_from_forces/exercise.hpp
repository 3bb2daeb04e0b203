/// \file
/// Exercise 11.1 - an ellipse of pressure from nodal forces. Do not change this file.
#pragma once
#include <Eigen/Core>

namespace ex11_1 {

/// What Hertz's theory says of a contact.
struct Ellipse {
  double centre;         ///< of the contact [length]
  double half_width;     ///< b [length]
  double peak_pressure;  ///< q_0 [force/length^2]
};

/// Finds the ellipse behind the contact forces of a whole contact, wherever its centre is.
///
/// The forces f belong to the nodes of a straight boundary with linear edges. They do the work of
/// the pressure on every displacement that is linear between the nodes, so that sum f and sum f x are
/// exact, and sum f (x - c)^2 is too large by what the pressure does with (x - x_i)(x_{i+1} - x).
/// Centre c: that of the forces. Half-width: 2 sqrt(M / sum f), where M is the second moment about c
/// less h^3 (s_i + s_{i+1}) / 12 for every edge of length h, with s = f / (half of the edges at the
/// node). Peak pressure: of the least-squares line through the squares of the pressures against
/// (x - c)^2, over the nodes with a force and |x - c| < 0.9 b; pressure = s / thickness.
/// If all of them are equally far from c, the root of the mean of the squared pressures.
/// \param position   `n` rising [length]
/// \param force      `n` >= 0, zero at open nodes [force]
/// \param thickness  across the plane [length], positive
/// \return centre, half-width, peak pressure
/// \throws std::invalid_argument if sizes differ, positions do not rise, the thickness is not positive
///   or fewer than three nodes carry a force
[[nodiscard]] Ellipse ellipse_of_forces(const Eigen::VectorXd& position,
                                        const Eigen::VectorXd& force, double thickness);

}  // namespace ex11_1

/// \file
/// Exercise 6.2 - pressure and touchdown from nodal forces. Do not change this file.
#pragma once
#include <Eigen/Core>

#include "meshes/block.hpp"

namespace ex6_2 {

/// What the contact forces of one boundary say.
struct ContactLine {
  Eigen::VectorXd pressure;  ///< `n` at the nodes [force/length^2], compression > 0
  double touchdown;          ///< where contact begins, coming from the first node [length]
};

/// Turns contact forces at the nodes of a straight boundary into pressures, and finds the touchdown.
///
/// The pressure of a node is its force over its weight, the integral of its shape function along the
/// boundary times the thickness. An edge of length h gives h/2 to both ends if it is linear, and
/// h/6, 4h/6, h/6 to end, middle and end if it is quadratic; a node belongs to one edge or two.
///
/// Near the touchdown s of a smooth body the pressure grows like sqrt(x - s), its square like a
/// straight line. The touchdown is where the line through the squares at the first two closed nodes
/// (pressure > 0) meets zero, but not before the last open node. It is
///   the first closed node if no node lies before or behind it, or the pressure does not grow;
///   the last node if no node is closed.
/// \param position      `n` along the boundary, increasing; middle nodes in the middle [length]
/// \param contact_force `n` >= 0, exactly 0 at open nodes [force]
/// \param order         Linear: every node is an end; Quadratic: end, middle, end, middle, ..., end
/// \param thickness     of the body across the plane [length], positive
/// \throws std::invalid_argument if sizes differ, there is no complete edge, the last quadratic edge
///   has no end, positions do not increase or the thickness is not positive
[[nodiscard]] ContactLine contact_line(const Eigen::VectorXd& position,
                                       const Eigen::VectorXd& contact_force,
                                       signorini::MeshOrder order, double thickness);

}  // namespace ex6_2

/// \file
/// Exercise 13.1 - what (46) gives to every node. Do not change this file.
#pragma once
#include <Eigen/Core>

namespace ex13_1 {

/// Force that a rigid smooth strip under a central load passes on between two points.
///
/// The integral of \PaperEq{LinEtAl, 46}, p = P / (pi sqrt(a^2 - x^2)) for |x| < a and 0 beside the strip,
/// from x_1 to x_2.
/// \param half_width  a [length], > 0
/// \param load        P on the whole strip [force/length]
/// \param from        x_1 [length], anywhere
/// \param to          x_2 [length], anywhere
/// \return force [force/length], compression > 0; negative if x_2 < x_1
/// \throws std::invalid_argument unless the half-width is positive
[[nodiscard]] double force_between(double half_width, double load, double from, double to);

/// How far the forces of nodes are from their shares of (46).
///
/// The share of a node reaches from the middle between it and its left neighbour to the middle between it
/// and its right one. The first node has no left neighbour and the last no right one: there the share begins
/// or ends at the node itself.
/// \param position    `n` increasing, from the axis to the edge or across the whole strip [length]
/// \param force       `n` of the nodes [force/length], compression > 0
/// \param half_width  a [length], > 0
/// \param load        P on the whole strip, not 0 [force/length]
/// \param within      only nodes with |x| <= within count [length]; 0.8 a keeps away from the edges
/// \return largest |force / share - 1| of them, 0 if there is none
/// \throws std::invalid_argument if sizes differ, or positions do not increase
[[nodiscard]] double largest_deviation(const Eigen::VectorXd& position,
                                       const Eigen::VectorXd& force, double half_width, double load,
                                       double within);

}  // namespace ex13_1

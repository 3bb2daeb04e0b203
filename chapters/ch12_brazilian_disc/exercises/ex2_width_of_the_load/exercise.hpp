/// \file
/// Exercise 12.2 - Hondros' arcs: what the width of the load costs. Do not change this file.
#pragma once

namespace ex12_2 {

/// Tension in the middle of a disc that is pressed by uniform normal pressure on two opposite arcs,
/// across the load, over what two line loads of the same resultant make there.
/// \param half_angle  alpha, half of one arc [rad], from 0 (line loads) to pi/2 (the whole rim)
/// \return sigma_x pi d / (2 P), P being the resultant of the pressure on one arc; 1 for alpha = 0,
///   < 0 where the middle is compressed
/// \throws std::invalid_argument if alpha is out of range or not a number
[[nodiscard]] double middle_tension(double half_angle);

/// The arc that loses a share of the tension: middle_tension() = 1 - loss.
/// \param loss  from 0 to 1 + pi/2, which is that of the whole rim
/// \return alpha [rad], with a relative error below 1e-9 however small the loss
/// \throws std::invalid_argument if the loss is out of range or not a number
[[nodiscard]] double widest_arc(double loss);

}  // namespace ex12_2

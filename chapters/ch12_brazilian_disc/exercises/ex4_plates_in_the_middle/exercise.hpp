/// \file
/// Exercise 12.4 - plates in the middle. Do not change this file.
#pragma once

namespace ex12_4 {

/// Which part of (44) the middle of a disc misses because the load is spread over a width. \PaperEq{LinEtAl, 44}
///
/// The load acts along y on both ends of every chord at x0, and makes P cos(alpha) (1 - 4 sin^2(alpha)) / (pi R) in the middle, with
/// R sin(alpha) = x0. Its share of P goes with the pressure of Hertz, sqrt(1 - x0^2 / b^2).
/// \param radius      R [length], > 0
/// \param half_width  b [length], from 0 to R
/// \param chords      that stand for all of them, 1 or more; 16 are enough for a relative error of 1e-10 if b is not above R / 4
/// \return 1 - sigma_x / (P / (pi R)) [-], with a relative error near rounding however small it is; 0 if b is 0
/// \throws std::invalid_argument unless radius, half-width and number of chords are such numbers
[[nodiscard]] double middle_loss(double radius, double half_width, int chords);

}  // namespace ex12_4

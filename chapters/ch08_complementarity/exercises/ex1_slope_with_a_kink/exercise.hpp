/// \file
/// Exercise 8.1 - a slope with a kink. Do not change this file.
#pragma once

namespace ex8_1 {

/// Both partial derivatives.
struct Slope {
  double a;  ///< d phi / d a, from -2 to 0 [-]
  double b;  ///< d phi / d b, from -2 to 0 [-]
};

/// The two derivatives of the Fischer-Burmeister function, \PaperEq{LinEtAl, 12}.
/// \param a  first argument, finite
/// \param b  second argument, finite
/// \return d phi / d a and d phi / d b, right to a few units in the last digit; at a = b = 0 the values along
///   a = b > 0
[[nodiscard]] Slope slope(double a, double b);

}  // namespace ex8_1

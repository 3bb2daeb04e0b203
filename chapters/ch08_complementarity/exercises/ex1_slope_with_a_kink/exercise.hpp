/// \file
/// Exercise 8.1 - a slope with a kink. Do not change this file.
#pragma once
#include "signorini/problem/complementarity_functions.hpp"

namespace ex8_1 {

/// The two derivatives of the Fischer-Burmeister function, \PaperEq{LinEtAl, 12}.
/// \param a  first argument, finite
/// \param b  second argument, finite
/// \return d phi / d a and d phi / d b, right to a few units in the last digit; at a = b = 0 the values along
///   a = b > 0
[[nodiscard]] signorini::ComplementaritySlope slope(double a, double b);

}  // namespace ex8_1

/// \file
/// Complementarity functions: one equation in the place of two inequalities and a product.
#pragma once
#include <cmath>

namespace signorini {

/// The Fischer-Burmeister function. \PaperEq{LinEtAl, 12} [\ref Fischer1992]
///
/// \f[ \varphi(a, b) = \sqrt{a^2 + b^2} - a - b \f]
///
/// is zero exactly where a >= 0, b >= 0 and a b = 0. The two numbers must have one unit: equal
/// residuals are else different errors. Where a + b > 0 the same number is computed as
/// \f$ -2ab / (\sqrt{a^2 + b^2} + a + b) \f$, which does not lose its digits near a solution.
/// \param a  a gap, scaled
/// \param b  a force, scaled to the same unit
/// \return phi(a, b), negative where both are positive
[[nodiscard]] inline double fischer_burmeister(double a, double b) {
  const double root = std::hypot(a, b);
  const double sum = a + b;
  return sum > 0 ? -2 * a * (b / (root + sum)) : root - sum;
}

/// The two partial derivatives of a complementarity function.
struct ComplementaritySlope {
  double a;  ///< d phi / d a, from -2 to 0
  double b;  ///< d phi / d b, from -2 to 0; never zero together with the other
};

/// The derivative of fischer_burmeister(), and at its kink one element of the generalised one.
///
/// At a = b = 0 the function has a slope for every direction; the direction a = b > 0 gives
/// \f$ (\sqrt{1/2} - 1, \sqrt{1/2} - 1) \f$. \f$ a/\sqrt{a^2 + b^2} - 1 \f$ is computed without
/// cancellation for a > 0.
/// \param a  first argument
/// \param b  second argument
/// \return both derivatives [-]
[[nodiscard]] inline ComplementaritySlope fischer_burmeister_slope(double a, double b) {
  const double root = std::hypot(a, b);
  if (root == 0) return {std::sqrt(0.5) - 1, std::sqrt(0.5) - 1};
  const auto slope = [root](double own, double other) {
    return own > 0 ? -(other / root) * (other / (root + own)) : own / root - 1;
  };
  return {slope(a, b), slope(b, a)};
}

}  // namespace signorini

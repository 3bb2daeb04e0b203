#include <cmath>

#include "exercise.hpp"
#include "signorini/core/errors.hpp"

namespace ex7_2 {

ContactAngle half_contact_angle(double wanted, double stiffness_ratio) {
  signorini::require_argument(std::isfinite(wanted) && stiffness_ratio > 0,
                              "half_contact_angle: need a finite number and a positive ratio, got ",
                              wanted, " and ", stiffness_ratio);
  const double pi = std::acos(-1.0);
  if (wanted <= -2 * stiffness_ratio / pi) return {pi, 0};  // touches all round
  // x = ln b^2: angles near 0 and near pi are far apart on this scale, and b^4 never overflows.
  double low = -700;
  double high = 150;
  double x = 0;
  double width = high - low;
  int evaluations = 0;
  while (evaluations < 200) {
    const double b2 = std::exp(x);
    const double denominator = pi * b2 * (1 + b2);
    const double value = (1 - stiffness_ratio * (std::log1p(b2) + 2 * b2 * b2)) / denominator;
    const double slope = -stiffness_ratio * b2 * (1 / (1 + b2) + 4 * b2) / denominator -
                         value * (1 + 2 * b2) / (1 + b2);
    ++evaluations;
    (value > wanted ? low : high) = x;
    const double newton = x - (value - wanted) / slope;
    if (std::abs(newton - x) <= 4e-16 * (1 + std::abs(x))) break;
    // Newton's step, unless it leaves the range or the last one has not halved it.
    const bool slow = high - low > 0.5 * width;
    width = high - low;
    x = newton > low && newton < high && !slow ? newton : 0.5 * (low + high);
  }
  return {2 * std::atan(std::exp(0.5 * x)), evaluations};
}

}  // namespace ex7_2

#include <cmath>

#include "exercise.hpp"
#include "signorini/core/errors.hpp"

namespace ex12_2 {
namespace {

const double pi = std::acos(-1.0);

// x - sin x without cancellation.
double beyond_sine(double x) {
  if (x > 0.5) return x - std::sin(x);
  double term = x * x * x / 6, sum = 0;
  for (int k = 4; sum + term != sum; k += 2) {
    sum += term;
    term *= -x * x / (k * (k + 1));
  }
  return sum;
}

// 1 - (sin 2a - a) / sin a.
double loss_of(double a) { return (beyond_sine(2 * a) - beyond_sine(a)) / std::sin(a); }

}  // namespace

double middle_tension(double half_angle) {
  signorini::require_argument(half_angle >= 0 && half_angle <= pi / 2,
                              "middle_tension: alpha = ", half_angle, ", expected 0 to pi/2");
  return half_angle == 0 ? 1 : 1 - loss_of(half_angle);
}

double widest_arc(double loss) {
  signorini::require_argument(loss >= 0 && loss <= 1 + pi / 2, "widest_arc: loss = ", loss,
                              ", expected 0 to 1 + pi/2");
  if (loss == 0) return 0;
  double low = 0, high = pi / 2;
  while (true) {  // halves until no number is left between
    const double a = low + (high - low) / 2;
    if (a <= low || a >= high) return a;
    (loss_of(a) < loss ? low : high) = a;
  }
}

}  // namespace ex12_2

#include <cmath>
#include <stdexcept>

#include "exercise.hpp"

namespace ex12_4 {

// 1 - cos(alpha) (1 - 4 s), s = sin^2(alpha); without a difference where the two terms nearly agree.
static double loss_of_chord(double s) {
  const double left = std::sqrt(1 - s) * (1 - 4 * s);
  return left > 0 ? s * (3 - 4 * s) * (3 - 4 * s) / (1 + left) : 1 - left;
}

double middle_loss(double radius, double half_width, int chords) {
  if (!(radius > 0) || !std::isfinite(radius))
    throw std::invalid_argument("middle_loss: the radius must be positive and finite");
  if (!(half_width >= 0 && half_width <= radius))
    throw std::invalid_argument("middle_loss: the half-width must be from 0 to the radius");
  if (chords < 1) throw std::invalid_argument("middle_loss: need a chord");
  double sum = 0, shares = 0;
  for (int k = 1; k <= chords; ++k) {
    const double angle = std::acos(-1.0) * k / (chords + 1);  // x = b cos(angle)
    const double share = std::sin(angle) * std::sin(angle);
    const double sine = half_width / radius * std::cos(angle);
    sum += share * loss_of_chord(sine * sine);
    shares += share;
  }
  return sum / shares;
}

}  // namespace ex12_4

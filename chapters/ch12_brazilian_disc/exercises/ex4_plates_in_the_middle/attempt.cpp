#include <cmath>

#include "exercise.hpp"

namespace ex12_4 {

// A uniform pressure: all chords have the same share. Change it to the ellipse, and mind the digits.
double middle_loss(double radius, double half_width, int chords) {
  double tension = 0;
  for (int k = 0; k < chords; ++k) {
    const double x = half_width * ((2 * k + 1.0) / chords - 1);
    const double s = x * x / (radius * radius);
    tension += std::sqrt(1 - s) * (1 - 4 * s) / chords;
  }
  return 1 - tension;
}

}  // namespace ex12_4

#include <algorithm>
#include <cmath>

#include "exercise.hpp"

namespace ex15_5 {

Law tresca(double c) {
  return {"tresca", [c](double /*force*/) { return c; }};
}

Law ceiling(double mu, double c) {
  return {"ceiling", [mu, c](double force) { return std::min(mu * force, c); }};
}

double step(const Law& law, double force, double hand, Slider& slider) {
  const double bound = force > 0 ? law.bound(force) : 0;
  const double stuck = slider.stiffness * (hand - slider.place);
  const double pull = std::clamp(stuck, -bound, bound);
  const double slip = (stuck - pull) / slider.stiffness;
  slider.place += slip;
  slider.lost += std::abs(pull * slip);
  return pull;
}

}  // namespace ex15_5

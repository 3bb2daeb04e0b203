#include "exercise.hpp"

namespace ex15_5 {

Law tresca(double c) {
  Law law = coulomb(c);  // your code here
  law.name = "tresca";
  return law;
}

Law ceiling(double mu, double /*c*/) {
  Law law = coulomb(mu);  // your code here
  law.name = "ceiling";
  return law;
}

double step(const Law& /*law*/, double /*force*/, double hand, Slider& slider) {
  return slider.stiffness * (hand - slider.place);  // your code here: this never slides
}

}  // namespace ex15_5

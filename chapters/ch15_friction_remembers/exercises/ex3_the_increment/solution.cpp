#include <algorithm>
#include <cmath>

#include "exercise.hpp"

namespace ex15_3 {

double step(const Sliders& sliders, double hand, State& state) {
  double pull = 0;
  for (Eigen::Index i = 0; i < sliders.bound.size(); ++i) {
    const double k = sliders.stiffness(i), B = sliders.bound(i);
    const double stuck = k * (hand - state.place(i));
    const double force = std::clamp(stuck, -B, B);
    if (force != stuck) {  // else it stays where it is, to the last bit
      const double slip = (stuck - force) / k;
      state.place(i) += slip;
      state.lost += std::abs(force * slip);
    }
    pull += force;
  }
  return pull;
}

}  // namespace ex15_3

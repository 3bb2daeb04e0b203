#include <cmath>

#include "exercise.hpp"

namespace ex7_4 {

// The linear gap: right to first order in clearance and shift. Change it to the distance.
Gap gap_at(const Fit& fit, double theta) {
  return {fit.clearance - fit.shift * std::cos(theta), std::cos(theta), std::sin(theta)};
}

}  // namespace ex7_4

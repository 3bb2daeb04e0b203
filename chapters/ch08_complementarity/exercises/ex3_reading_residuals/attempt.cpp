#include <cmath>

#include "exercise.hpp"

namespace ex8_3 {

std::vector<double> digits_gained(const std::vector<double>& residuals) {
  std::vector<double> gains;
  for (std::size_t k = 0; k + 1 < residuals.size(); ++k)
    gains.push_back(residuals[k] - residuals[k + 1]);  // your code here: digits
  return gains;
}

int period(const std::vector<double>& /*residuals*/) {
  return 0;  // your code here
}

Fate fate(const std::vector<double>& /*residuals*/) {
  return Fate::Unclear;  // your code here
}

std::optional<int> steps_left(const std::vector<double>& /*residuals*/, double /*target*/) {
  return std::nullopt;  // your code here
}

}  // namespace ex8_3

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "exercise.hpp"

namespace ex8_3 {

std::vector<double> digits_gained(const std::vector<double>& residuals) {
  if (residuals.size() < 4) throw std::invalid_argument("four residuals are needed");
  std::vector<double> gains;
  for (std::size_t k = 0; k < residuals.size(); ++k) {
    const bool last = k + 1 == residuals.size();
    if (!std::isfinite(residuals[k]) || residuals[k] < 0 || (residuals[k] == 0 && !last))
      throw std::invalid_argument("residuals must be positive and finite; the last may be 0");
    if (k > 0) gains.push_back(std::log10(residuals[k - 1] / residuals[k]));
  }
  return gains;
}

int period(const std::vector<double>& residuals) {
  static_cast<void>(digits_gained(residuals));  // refuses what is no run
  const std::size_t n = residuals.size();
  for (std::size_t p = 1; 2 * p <= n; ++p) {
    bool repeats = true;
    for (std::size_t k = n - p; k < n; ++k)
      repeats = repeats && std::abs(residuals[k] - residuals[k - p]) <= 1e-9 * residuals[k - p];
    if (repeats) return static_cast<int>(p);
  }
  return 0;
}

Fate fate(const std::vector<double>& residuals) {
  const std::vector<double> gains = digits_gained(residuals);
  if (period(residuals) > 0) return Fate::Round;
  const double a = gains[gains.size() - 3], b = gains[gains.size() - 2], c = gains.back();
  if (!(std::min({a, b, c}) > 0)) return Fate::Unclear;
  if (b >= 1.5 * a && c >= 1.5 * b) return Fate::Quick;
  return std::max({a, b, c}) <= 1.1 * std::min({a, b, c}) ? Fate::Steady : Fate::Unclear;
}

std::optional<int> steps_left(const std::vector<double>& residuals, double target) {
  if (!(target > 0)) throw std::invalid_argument("steps_left: the target must be positive");
  const std::vector<double> gains = digits_gained(residuals);
  if (residuals.back() <= target) return 0;
  const Fate is = fate(residuals);
  if (is != Fate::Quick && is != Fate::Steady) return std::nullopt;
  double gain = gains.back(), digits = std::log10(residuals.back() / target);
  const double grows =
      is == Fate::Quick ? std::min(2.0, gains.back() / gains[gains.size() - 2]) : 1;
  int steps = 0;
  for (; digits > 0; ++steps) {
    gain *= grows;
    digits -= gain;
  }
  return steps;
}

}  // namespace ex8_3

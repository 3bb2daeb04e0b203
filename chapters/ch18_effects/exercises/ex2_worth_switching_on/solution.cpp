#include <algorithm>
#include <cmath>

#include "exercise.hpp"
#include "signorini/core/errors.hpp"

namespace ex18_2 {

std::vector<Change> changes(const Fit& fit) {
  const double a = fit.bore, b = fit.radius, c = fit.outside;
  signorini::require_argument(0 < a && a < b && b < c, "changes: radii must grow, 0 < ", a, " < ",
                              b, " < ", c);
  signorini::require_argument(fit.modulus > 0 && fit.interference > 0,
                              "changes: modulus and interference must be positive, got ",
                              fit.modulus, " and ", fit.interference);
  const double shaft = b * b - a * a, hub = c * c - b * b, both = c * c - a * a;
  const double p0 = fit.modulus * fit.interference * shaft * hub / (2 * b * b * b * both);

  // Loads: minus the radial stress at b of one ring from a to c, spinning or pressed from outside.
  const double spin =
      -(3 + fit.ratio) / 8 * fit.density * fit.speed * fit.speed * shaft * hub / (b * b);
  const double pressed = fit.pressure * c * c * shaft / (b * b * both);
  // Heat: as if the interference were larger by what the two radii grow apart.
  const double grown =
      b * (fit.shaft_expansion * fit.shaft_warmer - fit.hub_expansion * fit.hub_warmer);
  // Friction: nothing slides, whatever mu is.
  std::vector<Change> all = {{"body force", spin / p0},
                             {"edge loads", pressed / p0},
                             {"temperature", grown / fit.interference},
                             {"friction", 0}};
  for (Change& change : all) change.share = std::max(-1.0, change.share);
  std::stable_sort(all.begin(), all.end(), [](const Change& one, const Change& two) {
    return std::abs(one.share) > std::abs(two.share);
  });
  return all;
}

std::vector<std::string> worth_switching_on(const Fit& fit, double accuracy) {
  signorini::require_argument(accuracy > 0, "worth_switching_on: accuracy must be positive, got ",
                              accuracy);
  const std::vector<Change> all = changes(fit);
  std::size_t needed = all.size();
  double left = 0;  // from the smallest up
  while (needed > 0 && left + std::abs(all[needed - 1].share) <= accuracy)
    left += std::abs(all[--needed].share);
  std::vector<std::string> names;
  for (std::size_t k = 0; k < needed; ++k) names.push_back(all[k].effect);
  return names;
}

}  // namespace ex18_2

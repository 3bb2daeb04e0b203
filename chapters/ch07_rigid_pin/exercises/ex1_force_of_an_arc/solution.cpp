#include <cmath>

#include "exercise.hpp"
#include "signorini/core/errors.hpp"

namespace ex7_1 {

Eigen::Vector2d arc_force(const Eigen::VectorXd& angle, const Eigen::VectorXd& pressure,
                          double radius, double thickness) {
  const Eigen::Index n = angle.size();
  signorini::require_argument(n >= 2 && pressure.size() == n,
                              "arc_force: need two angles or more and as many "
                              "pressures, got ",
                              n, " and ", pressure.size());
  signorini::require_argument(
      (angle.tail(n - 1) - angle.head(n - 1)).minCoeff() > 0 && radius > 0 && thickness > 0,
      "arc_force: angles must increase, radius and thickness be positive");
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (Eigen::Index k = 0; k + 1 < n; ++k) {
    // About the middle m of the segment, with half its opening h: p = mean + slope (t - m).
    const double h = (angle(k + 1) - angle(k)) / 2;
    const double m = angle(k) + h;
    const double mean = (pressure(k) + pressure(k + 1)) / 2;
    const double even = 2 * mean * std::sin(h);  // of cos(t - m)
    // Of (t - m) sin(t - m): 2 (sin h - h cos h), a difference that cancels for small h.
    const double moment = h < 1e-2 ? 2 * h * h * h / 3 * (1 - h * h / 10 * (1 - h * h / 28))
                                   : 2 * (std::sin(h) - h * std::cos(h));
    const double odd = (pressure(k + 1) - pressure(k)) / (2 * h) * moment;
    sum += even * Eigen::Vector2d(std::cos(m), std::sin(m)) +
           odd * Eigen::Vector2d(-std::sin(m), std::cos(m));
  }
  return radius * thickness * sum;
}

}  // namespace ex7_1

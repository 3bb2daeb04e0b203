#include <algorithm>
#include <cmath>

#include "exercise.hpp"
#include "signorini/core/errors.hpp"

namespace ex13_1 {

double force_between(double half_width, double load, double from, double to) {
  signorini::require_argument(half_width > 0, "force_between: half-width must be positive, got ",
                              half_width);
  const auto up_to = [&](double x) { return std::asin(std::clamp(x / half_width, -1.0, 1.0)); };
  return load / std::acos(-1.0) * (up_to(to) - up_to(from));
}

double largest_deviation(const Eigen::VectorXd& position, const Eigen::VectorXd& force,
                         double half_width, double load, double within) {
  const Eigen::Index n = position.size();
  signorini::require_argument(force.size() == n, "largest_deviation: need ", n, " forces, got ",
                              force.size());
  for (Eigen::Index k = 1; k < n; ++k)
    signorini::require_argument(position(k) > position(k - 1),
                                "largest_deviation: positions must increase, not so at ", k);
  double worst = 0;
  for (Eigen::Index k = 0; k < n; ++k) {
    if (std::abs(position(k)) > within) continue;
    const double left = k == 0 ? position(k) : (position(k - 1) + position(k)) / 2;
    const double right = k == n - 1 ? position(k) : (position(k) + position(k + 1)) / 2;
    const double share = force_between(half_width, load, left, right);
    worst = std::max(worst, std::abs(force(k) / share - 1));
  }
  return worst;
}

}  // namespace ex13_1

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "exercise.hpp"

namespace ex13_5 {

namespace {

// Between the left edge and x; |e| <= a/2. The part beside (46) is a function that is zero at both edges.
double force_up_to(const Strip& strip, double x) {
  const double s = std::clamp(x / strip.half_width, -1.0, 1.0);
  const double e = strip.eccentricity / strip.half_width;
  return strip.load / std::acos(-1.0) *
         (std::asin(s) - std::asin(-1.0) - 2 * e * std::sqrt((1 - s) * (1 + s)));
}

}  // namespace

Eigen::VectorXd shares(const Strip& strip, const Eigen::VectorXd& position) {
  const double a = strip.half_width, e = strip.eccentricity;
  if (!(a > 0 && strip.load > 0 && std::abs(e) < a))
    throw std::invalid_argument("shares: a and P must be positive, and the load above the strip");
  Strip bears = strip;
  double middle = 0;
  if (std::abs(e) > a / 2) {
    const double b = 2 * (a - std::abs(e)), side = e > 0 ? 1 : -1;
    bears = {b, strip.load, side * b / 2};
    middle = side * (a - b);
  }
  const Eigen::Index n = position.size();
  Eigen::VectorXd share(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const double left = k == 0 ? position(0) : (position(k - 1) + position(k)) / 2;
    const double right = k == n - 1 ? position(k) : (position(k) + position(k + 1)) / 2;
    share(k) = force_up_to(bears, right - middle) - force_up_to(bears, left - middle);
  }
  return share;
}

}  // namespace ex13_5

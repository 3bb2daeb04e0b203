#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "exercise.hpp"

namespace ex13_5 {

namespace {

// Of a load in the middle, between the left edge and x.
double force_up_to(const Strip& strip, double x) {
  const double s = std::clamp(x / strip.half_width, -1.0, 1.0);
  return strip.load / std::acos(-1.0) * (std::asin(s) - std::asin(-1.0));
}

}  // namespace

Eigen::VectorXd shares(const Strip& strip, const Eigen::VectorXd& position) {
  if (!(strip.half_width > 0 && strip.load > 0)) throw std::invalid_argument("shares: bad strip");
  const Eigen::Index n = position.size();
  Eigen::VectorXd share(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const double left = k == 0 ? position(0) : (position(k - 1) + position(k)) / 2;
    const double right = k == n - 1 ? position(k) : (position(k) + position(k + 1)) / 2;
    share(k) = force_up_to(strip, right) - force_up_to(strip, left);
  }
  return share;  // your code here: this leaves out where the load acts
}

}  // namespace ex13_5

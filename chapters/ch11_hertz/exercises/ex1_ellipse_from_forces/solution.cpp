#include <cmath>

#include "exercise.hpp"
#include "signorini/core/errors.hpp"

namespace ex11_1 {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Force per length: every edge gives half of itself to both ends.
VectorXd per_length(const VectorXd& x, const VectorXd& force) {
  VectorXd share = VectorXd::Zero(x.size());
  for (Index k = 0; k + 1 < x.size(); ++k) share.segment<2>(k).array() += (x(k + 1) - x(k)) / 2;
  return force.cwiseQuotient(share);
}

double half_width(const VectorXd& x, const VectorXd& force, const VectorXd& s) {
  double moment = force.dot(x.cwiseAbs2());
  for (Index k = 0; k + 1 < x.size(); ++k)
    moment -= std::pow(x(k + 1) - x(k), 3) * (s(k) + s(k + 1)) / 12;
  return 2 * std::sqrt(moment / force.sum());
}

// Height at x = 0 of the line through (x^2, p^2); two sums about the means.
double peak(const VectorXd& x, const VectorXd& p, double reach) {
  double n = 0, x2 = 0, p2 = 0;
  const auto counts = [&](Index k) { return p(k) > 0 && std::abs(x(k)) < reach; };
  for (Index k = 0; k < x.size(); ++k)
    if (counts(k)) n += 1, x2 += x(k) * x(k), p2 += p(k) * p(k);
  x2 /= n;
  p2 /= n;
  double square = 0, product = 0;
  for (Index k = 0; k < x.size(); ++k)
    if (counts(k)) {
      square += std::pow(x(k) * x(k) - x2, 2);
      product += (x(k) * x(k) - x2) * (p(k) * p(k) - p2);
    }
  return std::sqrt(square > 0 ? p2 - product / square * x2 : p2);
}

}  // namespace

Ellipse ellipse_of_forces(const VectorXd& position, const VectorXd& force, double thickness) {
  const Index n = position.size();
  signorini::require_argument(force.size() == n, "ellipse_of_forces: need ", n, " forces, got ",
                              force.size());
  signorini::require_argument((force.array() > 0).count() >= 3,
                              "ellipse_of_forces: at least three nodes must carry a force");
  signorini::require_argument(
      (position.tail(n - 1) - position.head(n - 1)).minCoeff() > 0 && thickness > 0,
      "ellipse_of_forces: positions must rise and the thickness be positive");
  const double centre = force.dot(position) / force.sum();
  const VectorXd x = position.array() - centre;
  const VectorXd s = per_length(x, force);
  const double b = half_width(x, force, s);
  return {centre, b, peak(x, s / thickness, 0.9 * b)};
}

}  // namespace ex11_1

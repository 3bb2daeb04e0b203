#include "signorini/contact/dual_basis.hpp"

namespace signorini {
namespace {

/// Slack of comparisons that exact arithmetic may decide as a tie: symmetric data, symmetric answer.
constexpr double slack = 1e-9;

}  // namespace

DualBasis dual_basis(const std::vector<EdgePoint>& covered, const Eigen::Vector2d& share) {
  DualBasis basis;
  for (const EdgePoint& point : covered) {
    basis.length += point.length;
    basis.mean += point.length * end_shape(point.s);
  }
  if (basis.length == 0) return basis;
  const Eigen::Vector2d part = basis.mean.cwiseQuotient(share);
  basis.mean /= basis.length;
  basis.centre = basis.mean(1) - basis.mean(0);
  if (part.minCoeff() < 0.5 - slack) {
    const bool second = part(1) > part(0) * (1 + slack);
    basis.mean = second ? Eigen::Vector2d(0, 1) : Eigen::Vector2d(1, 0);
    return basis;
  }
  double variance = 0;
  for (const EdgePoint& point : covered)
    variance += point.length / basis.length * (point.s - basis.centre) * (point.s - basis.centre);
  // A single point has no spread: both ends see the same gap.
  if (covered.size() > 1) basis.slope = 2 * basis.mean(0) * basis.mean(1) / variance;
  return basis;
}

}  // namespace signorini

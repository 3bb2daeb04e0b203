#include <algorithm>
#include <cmath>

#include "exercise.hpp"
#include "signorini/core/errors.hpp"

namespace ex14_3 {

FirstGaps first_gaps(const signorini::Scene& scene) {
  const Eigen::VectorXd gap = signorini::plan(scene).gaps.pairs.initial_gap;
  if (gap.size() == 0) return {};
  return {gap.size(), (gap.array() < 0).count(), gap.minCoeff(), gap.maxCoeff()};
}

bool as_drawn(const FirstGaps& gaps, double drawn, double part) {
  const double worst = std::max(drawn - gaps.least, gaps.most - drawn);
  return gaps.pairs == 0 || worst <= part * std::abs(drawn);
}

Eigen::Index sides_needed(double radius, double gap, double part) {
  signorini::require_argument(radius > 0 && gap > 0 && part > 0,
                              "sides_needed: radius, gap and part must be positive, got ", radius,
                              ", ", gap, " and ", part);
  const double root = std::sqrt(part * gap / radius / 2);  // 1 - cos t = 2 sin^2(t/2)
  const double quarter = std::acos(0.0);
  if (root >= std::sin(quarter / 4)) return 1;
  return static_cast<Eigen::Index>(std::ceil(quarter / (4 * std::asin(root))));
}

}  // namespace ex14_3

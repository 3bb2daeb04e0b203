#include <cmath>

#include "exercise.hpp"
#include "signorini/core/errors.hpp"

namespace ex1_1 {

LinearGaps profile_gaps(const signorini::NodeArray& points,
                        const std::function<double(double)>& height,
                        const std::function<double(double)>& slope) {
  const Eigen::Index n_c = points.rows();
  LinearGaps gaps{Eigen::VectorXd::Zero(n_c), Eigen::MatrixXd::Zero(n_c, 2 * n_c)};
  for (Eigen::Index i = 0; i < n_c; ++i) {
    const double f = height(points(i, 0));
    const double df = slope(points(i, 0));
    signorini::require_input(std::isfinite(f) && std::isfinite(df), "profile_gaps: height ", f,
                             " and slope ", df, " at x = ", points(i, 0), " must be finite");
    const double root = std::hypot(1.0, df);
    const Eigen::Vector2d normal(-df / root, 1 / root);  // out of the floor: n_y > 0
    // The root is in n_y already; eq. (2) as printed divides by it once more.
    gaps.initial_gap(i) = normal.y() * (points(i, 1) - f);
    // gap = g + n.u for the point, and gap = g - A u by definition: the row is minus the normal.
    gaps.A.row(i).segment<2>(2 * i) = -normal.transpose();
  }
  return gaps;
}

}  // namespace ex1_1

#include <stdexcept>

#include "exercise.hpp"

namespace ex0_1 {

Eigen::Matrix<double, 6, 6> triangle_stiffness(const Eigen::Matrix<double, 3, 2>& corners,
                                               const Eigen::Matrix3d& D, double thickness) {
  const Eigen::RowVector2d one = corners.row(1) - corners.row(0);
  const Eigen::RowVector2d two = corners.row(2) - corners.row(0);
  const double area = (one(0) * two(1) - one(1) * two(0)) / 2;
  if (!(area > 0) || !(thickness > 0) || !corners.allFinite())
    throw std::invalid_argument("triangle_stiffness: corners must run anticlockwise");
  Eigen::Matrix<double, 3, 6> B;
  for (Eigen::Index k = 0; k < 3; ++k) {
    // the side opposite corner k, turned by a right angle, points to it
    const Eigen::RowVector2d side = corners.row((k + 2) % 3) - corners.row((k + 1) % 3);
    const double dx = -side(1) / (2 * area), dy = side(0) / (2 * area);
    B.middleCols<2>(2 * k) << dx, 0, /**/ 0, dy, /**/ dy, dx;
  }
  return area * thickness * B.transpose() * D * B;
}

}  // namespace ex0_1

#include "exercise.hpp"

namespace ex7_1 {

Eigen::Vector2d arc_force(const Eigen::VectorXd& /*angle*/, const Eigen::VectorXd& /*pressure*/,
                          double /*radius*/, double /*thickness*/) {
  // your code here: angle by angle, the integral of a linear pressure times (cos t, sin t)
  return Eigen::Vector2d::Zero();
}

}  // namespace ex7_1

#include "exercise.hpp"

namespace ex12_1 {

Eigen::Vector3d line_load_stress(double /*force*/, const Eigen::Vector2d& /*foot*/,
                                 const Eigen::Vector2d& /*direction*/,
                                 const Eigen::Vector2d& /*at*/) {
  return Eigen::Vector3d::Zero();  // your code here
}

Eigen::Vector3d disc_stress(double /*radius*/, double /*force*/, double /*angle*/,
                            const Eigen::Vector2d& /*at*/) {
  return Eigen::Vector3d::Zero();  // your code here: two forces and a uniform tension
}

}  // namespace ex12_1

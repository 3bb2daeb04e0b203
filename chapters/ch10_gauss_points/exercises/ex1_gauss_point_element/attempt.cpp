#include "exercise.hpp"

namespace ex10_1 {

Element gauss_point(const Edges& /*edges*/, double /*xi*/, double /*weight*/, double /*pressure*/,
                    double /*shear*/) {
  // your code here: the point, the foot on the target, the force there, its shares on four nodes
  return {Eigen::Vector2d::Zero(), 0, Eigen::Matrix<double, 4, 2>::Zero()};
}

}  // namespace ex10_1

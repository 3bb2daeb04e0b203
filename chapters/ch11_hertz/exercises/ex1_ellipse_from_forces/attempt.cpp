#include "exercise.hpp"

namespace ex11_1 {

Ellipse ellipse_of_forces(const Eigen::VectorXd& /*position*/, const Eigen::VectorXd& /*force*/,
                          double /*thickness*/) {
  // your code here: centre, second moment, correction edge by edge, then the line
  return {0, 0, 0};
}

}  // namespace ex11_1

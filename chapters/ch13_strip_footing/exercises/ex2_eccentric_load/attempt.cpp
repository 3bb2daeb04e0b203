#include "exercise.hpp"

namespace ex13_2 {

Rest come_to_rest(const Eigen::MatrixXd& /*compliance*/, const Eigen::VectorXd& position,
                  double /*load*/, double /*eccentricity*/) {
  return {Eigen::VectorXd::Zero(position.size()), 0, 0};  // your code here
}

}  // namespace ex13_2

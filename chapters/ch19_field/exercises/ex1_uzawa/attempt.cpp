#include "exercise.hpp"

namespace ex19_1 {

Ending uzawa(const Eigen::MatrixXd& /*G*/, const Eigen::VectorXd& free_gap, double /*accuracy*/,
             Eigen::Index /*most*/) {
  Ending now{Eigen::VectorXd::Zero(free_gap.size())};
  // your code here
  return now;
}

}  // namespace ex19_1

#include "exercise.hpp"

namespace ex2_1 {

Eigen::VectorXd gradient(const Eigen::MatrixXd& /*compliance*/, const Eigen::VectorXd& free_gap,
                         const Eigen::VectorXd& /*weights*/) {
  // your code here: the total force first, then the gaps that it leaves
  return Eigen::VectorXd::Zero(free_gap.size());
}

}  // namespace ex2_1

#include "exercise.hpp"

namespace ex4_1 {

Moved move_minimum(const Eigen::MatrixXd& /*stiffness*/, const Eigen::MatrixXd& /*A*/,
                   const Eigen::VectorXd& /*initial_gap*/, const Eigen::VectorXd& u) {
  Moved moved;
  moved.displacement = u;
  // your code here: violated rows, their compliance and gaps, their forces, the new minimum
  return moved;
}

}  // namespace ex4_1

#include "exercise.hpp"

namespace ex1_2 {

Rest solve_by_trial(const Eigen::MatrixXd& /*stiffness*/, const Eigen::VectorXd& load,
                    const Eigen::MatrixXd& /*A*/, const Eigen::VectorXd& initial_gap) {
  // your code here: free gap and compliance first, then a loop over all sets
  return {Eigen::VectorXd::Zero(load.size()), Eigen::VectorXd::Zero(initial_gap.size())};
}

}  // namespace ex1_2

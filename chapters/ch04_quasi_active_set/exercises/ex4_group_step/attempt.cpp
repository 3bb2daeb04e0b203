#include "exercise.hpp"

namespace ex4_4 {

Rows group_of(const signorini::ContactProblem& /*problem*/, const Eigen::VectorXd& /*force*/) {
  return {};  // nobody joins: your code here
}

Round group_step(const signorini::ContactProblem& /*problem*/, const Eigen::VectorXd& old,
                 const Rows& /*group*/) {
  return {old, true};  // your code here
}

}  // namespace ex4_4

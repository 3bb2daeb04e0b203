#include "exercise.hpp"

namespace ex17_2 {

Eigen::VectorXd forces_of(const signorini::ContactProblem& problem, double /*stiffness*/) {
  return Eigen::VectorXd::Zero(problem.free_gap.size());  // your code here
}

double stiffness_for(const signorini::ContactProblem& /*problem*/, double /*share*/) {
  return 1e6;  // your code here
}

}  // namespace ex17_2

#include "exercise.hpp"

namespace ex8_4 {

Inner central(const signorini::ContactProblem& problem, double /*epsilon*/) {
  return {0 * problem.free_gap, problem.free_gap};  // your code here
}

Eigen::VectorXd through_the_inside(const signorini::ContactProblem& problem) {
  return 0 * problem.free_gap;  // your code here
}

}  // namespace ex8_4

#include "exercise.hpp"

namespace ex17_3 {

bool proves(const signorini::ContactProblem& problem, const Eigen::VectorXd& y) {
  return problem.free_gap.dot(y) < 0;  // your code here: and what else?
}

Eigen::VectorXd find_proof(const signorini::ContactProblem& /*problem*/) {
  return {};  // your code here
}

}  // namespace ex17_3

#include "exercise.hpp"

namespace ex17_1 {

Fault fault_of(const signorini::ContactProblem& problem, const Eigen::VectorXd& force,
               const Eigen::VectorXd& gap) {
  const Eigen::VectorXd made = problem.free_gap + problem.compliance * force;
  if ((made - gap).cwiseAbs().maxCoeff() > 1e-9) return Fault::Movement;
  return Fault::None;  // your code here
}

}  // namespace ex17_1

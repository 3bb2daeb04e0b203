#include "exercise.hpp"

namespace ex2_4 {

Traded trade_groups(const signorini::ContactProblem& problem, const Eigen::VectorXd& /*weight*/,
                    const std::vector<Eigen::Index>& /*group*/) {
  Traded traded;  // no group has a force: your code here
  traded.total = Eigen::VectorXd::Zero(1);
  traded.force = Eigen::VectorXd::Zero(problem.free_gap.size());
  return traded;
}

}  // namespace ex2_4

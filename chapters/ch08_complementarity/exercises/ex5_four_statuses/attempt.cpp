#include "exercise.hpp"

namespace ex8_5 {

std::vector<Status> statuses_at(const Problem& /*problem*/, double /*c*/,
                                const Eigen::VectorXd& force, const Eigen::VectorXd& /*friction*/) {
  return std::vector<Status>(static_cast<std::size_t>(force.size()));  // your code here
}

Eigen::VectorXd forces_of(const Problem& problem, const std::vector<Status>& /*statuses*/) {
  return Eigen::VectorXd::Zero(2 * problem.free_gap.size());  // your code here
}

Answer semismooth(const Problem& problem, double /*c*/) {
  return {0 * problem.free_gap, 0 * problem.free_gap, {}, 0, false};  // your code here
}

}  // namespace ex8_5

#include <algorithm>
#include <stdexcept>

#include "exercise.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"

namespace ex2_4 {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Traded trade_groups(const signorini::ContactProblem& problem, const VectorXd& weight,
                    const std::vector<Index>& group) {
  const Index n = problem.free_gap.size();
  if (weight.size() != n || static_cast<Index>(group.size()) != n || n == 0)
    throw std::invalid_argument("trade_groups: every pair has a weight and a group");
  if (!(weight.array() >= 0).all() || *std::min_element(group.begin(), group.end()) < 0)
    throw std::invalid_argument("trade_groups: weights and numbers of groups are not negative");
  MatrixXd share = MatrixXd::Zero(n, *std::max_element(group.begin(), group.end()) + 1);
  for (Index i = 0; i < n; ++i) share(i, group[static_cast<std::size_t>(i)]) = weight(i);
  const Eigen::RowVectorXd sum = share.colwise().sum();
  if (!(sum.array() > 0).all()) throw std::invalid_argument("trade_groups: a group has no weight");
  share.array().rowwise() /= sum.array();
  const signorini::ContactProblem groups{share.transpose() * problem.compliance * share,
                                         share.transpose() * problem.free_gap};
  Traded traded;
  traded.total = signorini::primal_dual_active_set(groups).force;
  traded.force = share * traded.total;
  traded.energy =
      -0.5 * groups.free_gap.dot(traded.total);  // the gaps of groups with a force are 0
  return traded;
}

}  // namespace ex2_4

#include <stdexcept>

#include "exercise.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"

namespace ex1_5 {

Rest come_to_rest(const signorini::ContactProblem& problem, const Eigen::VectorXd& yield) {
  if (yield.size() != problem.free_gap.size() || !(yield.array() >= 0).all())
    throw std::invalid_argument("come_to_rest: needs one yield >= 0 for each pair");
  signorini::ContactProblem yielding = problem;
  yielding.compliance.diagonal() += yield;
  const signorini::ContactState state = signorini::primal_dual_active_set(yielding);
  return {state.force, state.gap - yield.cwiseProduct(state.force)};
}

}  // namespace ex1_5

#include "exercise.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"

namespace ex1_5 {

Rest come_to_rest(const signorini::ContactProblem& problem, const Eigen::VectorXd& /*yield*/) {
  // Right for rigid stops: your changes here
  const signorini::ContactState state = signorini::primal_dual_active_set(problem);
  return {state.force, state.gap};
}

}  // namespace ex1_5

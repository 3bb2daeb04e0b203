#include "signorini/solvers/fischer_burmeister.hpp"

#include <utility>

#include "addons/certified/proofs.hpp"
#include "signorini/solvers/newton.hpp"

namespace signorini {

using Eigen::Index;
using Eigen::VectorXd;

ContactState fischer_burmeister(const ContactProblem& problem, const SolverOptions& options) {
  const bool frictional = !problem.law.pair.empty();
  if (problem.resultant.size() > 0) check_problem(problem);
  const ScaledProblem scaled = equilibrate_any(problem);
  if (auto away = infeasible_resultant(problem, scaled)) return *away;
  const bool limited = options.iteration_limit > 0;
  const Index own_limit = frictional ? newton_limit : 10 * scaled.pairs() + 100;
  Iterate iterate = first_iterate(scaled);
  follow_newton(scaled, nested_friction, limited ? options.iteration_limit : own_limit, iterate);
  if (frictional && !limited && !iterate.confirmed)
    primal_dual_iterations(scaled, exchange_limit, iterate);
  if (frictional && !limited && !iterate.confirmed) follow_pivots(scaled, {}, iterate);
  return finished(problem, scaled, std::move(iterate));
}

Solver fischer_burmeister() {
  return Solver{"fischer_burmeister",
                "one equation per pair, solved by Newton's method with a line search",
                fischer_burmeister}
      .may_fail_on({Trait::Dependent, Trait::Infeasible})
      .with_friction(Takes::Also)
      .with_rigid_modes();
}

}  // namespace signorini

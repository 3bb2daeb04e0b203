#include "signorini/solvers/fischer_burmeister.hpp"

#include <utility>

#include "signorini/solvers/lemke.hpp"
#include "signorini/solvers/newton.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"

namespace signorini {

using Eigen::Index;

ContactState fischer_burmeister(const ContactProblem& problem, const SolverOptions& options) {
  if (problem.resultant.size() > 0) check_problem(problem);
  const ScaledProblem scaled = equilibrate_any(problem);
  const Index most = problem.law.pair.empty() ? 10 * scaled.pairs() + 100 : newton_limit;
  Iterate iterate = first_iterate(scaled);
  follow_newton(scaled, nested_friction,
                options.iteration_limit > 0 ? options.iteration_limit : most, iterate);
  return finished(problem, scaled, std::move(iterate));
}

Solver fischer_burmeister() {
  return Solver{"fischer_burmeister",
                "one equation per pair, solved by Newton's method with a line search",
                fischer_burmeister}
      .may_fail_on({Trait::Dependent, Trait::Infeasible})
      .with_friction(Takes::Also)
      .with_rigid_modes()
      .before({primal_dual_active_set, lemke});
}

}  // namespace signorini

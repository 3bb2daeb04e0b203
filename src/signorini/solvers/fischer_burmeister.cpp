// # The Fischer-Burmeister method
//
// Gap and force of a pair are complementary exactly where \f$ \varphi(g, \lambda) = 0 \f$, with
// \f$ \varphi(a, b) = \sqrt{a^2 + b^2} - a - b \f$. So contact is as many equations as pairs, and
// Newton's method may solve them. \f$ \varphi \f$ has a kink only where gap and force are both
// zero. Elsewhere it weighs how wrong both numbers are, where the primal-dual active set only asks
// which of them is larger. Which of the two needs fewer steps depends on the problem; with shortened
// steps this one does not cycle.
//
// One step by hand: G = 1, d = -1, from \f$ \lambda = 0 \f$. The gap is -1, so \f$ \varphi = 2 \f$,
// and its slopes are -2 for the gap and -1 for the force. The slope along \f$ \lambda \f$ is
// \f$ -2 \cdot G - 1 = -3 \f$, and Newton's method goes to \f$ \lambda = 2/3 \f$. There the gap is
// -1/3 and \f$ \varphi = 0.41 \f$. The next step arrives at 0.93; the solution is 1.
//
// The equations are in [contact_equations.cpp](../problem/contact_equations.cpp), the steps in
// [newton.cpp](newton.cpp).

#include "signorini/solvers/fischer_burmeister.hpp"

#include <utility>

#include "signorini/solvers/newton.hpp"

namespace signorini {

using Eigen::Index;

// With friction there is one more equation per slip. Newton's method then arrives in a few steps or
// not at all, so its limit is small.
ContactState fischer_burmeister(const ContactProblem& problem, const SolverOptions& options) {
  if (problem.resultant.size() > 0) check_problem(problem);
  const ScaledProblem scaled = equilibrate_any(problem);
  const Index most = problem.law.pair.empty() ? 10 * scaled.pairs() + 100 : newton_limit;
  Iterate iterate = first_iterate(scaled);
  follow_newton(scaled, nested_friction,
                options.iteration_limit > 0 ? options.iteration_limit : most, iterate);
  return finished(problem, scaled, std::move(iterate));
}

}  // namespace signorini

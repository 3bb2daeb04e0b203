// # The primal-dual active set
//
// A contact problem asks three things of every pair i: its force presses, \f$ \lambda_i \ge 0 \f$;
// its gap does not overlap, \f$ g_i \ge 0 \f$ with \f$ g = d + G\lambda \f$; and one of the two is
// zero. For any c > 0 these are one equation,
// \f[ \lambda_i = \max(0,\; \lambda_i - c\,g_i). \f]
// The maximum has a kink, and on either side of it it is linear. Newton's method for such an
// equation uses a generalised derivative: the slope of the side on which the last iterate stands.
// Where \f$ \lambda_i > c\,g_i \f$ the slope is 1, and the linearised equation says
// \f$ g_i = 0 \f$: the pair is closed. Elsewhere the slope is 0, and it says \f$ \lambda_i = 0 \f$:
// the pair is open. So one step of this *semi-smooth Newton method* is a step of an *active set
// method*. Hintermüller, Ito and Kunisch (2002) saw that the two are one method:
//
//     W = the pairs with d_i < 0
//     repeat:
//       lambda_W = solution of G_WW lambda_W = -d_W, and lambda_i = 0 for all other pairs
//       g = d + G lambda
//       V = the pairs with lambda_i > c g_i
//       if V = W: lambda is the solution
//       W = V
//
// The three carts of chapter 1 have
// \f[ G = \begin{pmatrix} 1 & 1 & 1 \\ 1 & 2 & 2 \\ 1 & 2 & 3 \end{pmatrix}, \qquad d = (-2, -1, -3). \f]
// All three overlap. Closed together they have the forces (3, -3, 2): the one in the middle would
// pull. Released, it has the gap 1.5, and the forces are (1.5, 0, 0.5). Nothing is wrong any more,
// so the second set is the solution.
//
// Newton's method makes no promise far from the solution: a step is never shortened, and no number
// has to fall from set to set. So the method can cycle. With
// \f[ G = \begin{pmatrix} 4 & -6 & -4 \\ -6 & 10 & 8 \\ -4 & 8 & 9 \end{pmatrix}, \qquad d = (3, -4, -1) \f]
// the closed pairs are {2, 3}, then {1, 2}, then none, then {2, 3} again. The safeguard notices
// that a set comes back. From there on only the wrong pair with the lowest number changes sides,
// and the sets are {1, 2, 3}, {1, 2} and {2}, which is the solution.

#include "signorini/solvers/primal_dual_active_set.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "signorini/solvers/iterate.hpp"

namespace signorini {
namespace {

using Eigen::Index;

// Leaves the first difference between two lists alone. This is Murty's rule (1974). For a positive
// definite G it comes to the solution after finitely many sets. It changes one pair at a time, so
// it is the way out of a cycle and not the method.
void keep_first_change(const std::vector<ContactStatus>& last, std::vector<ContactStatus>& next) {
  const auto [was, is] = std::mismatch(last.begin(), last.end(), next.begin());
  if (is != next.end()) std::copy(was + 1, last.end(), is + 1);
}

}  // namespace

// With friction the exchange arrives after five to ten sets, or it cycles. Without friction Murty's
// rule may take over, and it may need many sets.
Index most_exchanges(const ScaledProblem& problem) {
  return problem.law.pair.empty() ? 10 * problem.pairs() + 10 : 50;
}

// The loop, with what can go wrong. predict() is the maximum: it compares force and gap, and lets a
// pair that is within rounding of the kink stay what it was. Otherwise rounding could move pairs to
// and fro for ever.
//
// A set alone determines the next one if bodies are held and no pair has friction. One that comes
// back would then come back for ever, and Murty's rule takes over. With friction or rigid modes
// there is no such theorem, and the method stops.
//
// A system may leave something undetermined, the motion of a body that one pair lets roll, or the
// share of each of two equal rows. solve_active_set() then keeps the numbers of `start`. With
// friction these are those of the set before; with rigid modes alone, those of the first iterate.
//
// Of rows that repeat each other the one that overlapped most is closed: it stands first in the set.
//
// If no pair changes, the set is only a claim. solves() confirms it with all conditions of contact.
void primal_dual_iterations(const ScaledProblem& problem, Index limit, Iterate& iterate) {
  const bool frictional = !problem.law.pair.empty();
  const bool plain = !frictional && problem.rigid.cols() == 0;
  const double unit = force_scale(problem.compliance);
  std::set<std::vector<ContactStatus>> seen;
  bool one_at_a_time = false;
  ActiveSetSolution start = iterate.solution;
  iterate.stop(SolveStatus::IterationLimit, "the contact statuses did not settle");
  for (Index step = 0; step < limit; ++step) {
    if (!seen.insert(iterate.statuses).second) {
      iterate.reason = "the same contact statuses come back";
      one_at_a_time = true;
      if (!plain) return;
    }
    const ActiveSet set = surest_first(problem, iterate.statuses, iterate.solution.movement);
    // A set without closed pairs needs no factorisation: its forces are known.
    iterate.report.factorisations += set.closed.empty() ? 0 : 1;
    ++iterate.report.iterations;
    iterate.solution = solve_active_set(problem, set, plain ? nullptr : &start);
    const ActiveSetSolution& now = iterate.solution;
    if (frictional) start = now;
    if (!now.force.allFinite() || !now.movement.allFinite() || (!frictional && !now.solvable))
      return iterate.stop(SolveStatus::Breakdown, "the equations of the closed pairs are singular");
    const bool dependent = !frictional && now.rows.size() < set.closed.size();
    if (dependent && one_at_a_time) return iterate.stop(SolveStatus::Breakdown);
    if (dependent) iterate.statuses = statuses_of(now.rows, problem.pairs());
    std::vector<ContactStatus> next = iterate.statuses;
    const Index changes = predict(problem, now, unit, next);
    iterate.report.history.push_back(summary(problem, iterate.statuses, now, changes));
    if (changes == 0) {
      iterate.confirmed = solves(problem, iterate.statuses, now);
      return iterate.confirmed ? void() : iterate.stop(SolveStatus::Breakdown);
    }
    if (one_at_a_time) keep_first_change(iterate.statuses, next);
    if (step + 1 < limit) iterate.statuses = std::move(next);
  }
}

// A start that is given, such as the statuses of a load step before, often is the solution or near
// it. If it leads nowhere, the method begins again from its own start, and the report counts both
// runs.
ContactState primal_dual_active_set(const ContactProblem& problem, const SolverOptions& options) {
  const bool frictional = !problem.law.pair.empty();
  const bool known = options.known == &problem, any = frictional && problem.resultant.size() == 0;
  const ScaledProblem own = known ? ScaledProblem() : any ? equilibrate_any(problem) : equilibrate(problem);
  const ScaledProblem& scaled = known ? *options.scaled : own;
  const Index asked = options.iteration_limit;
  const Index most = most_exchanges(scaled);
  const Index limit = asked == 0 ? most : frictional ? asked : std::min(asked, most);
  Iterate iterate;
  if (static_cast<Index>(options.start.size()) == scaled.pairs()) {
    iterate = iterate_from(scaled, options.start);
    primal_dual_iterations(scaled, limit, iterate);
    if (iterate.confirmed || asked > 0) return finished(problem, scaled, std::move(iterate));
  }
  const Report so_far = std::move(iterate.report);
  iterate = coarse_iterate(scaled);
  append(iterate.report, so_far);
  primal_dual_iterations(scaled, limit, iterate);
  return finished(problem, scaled, std::move(iterate));
}

}  // namespace signorini

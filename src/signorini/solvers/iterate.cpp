// # Where methods start and how they end
//
// The exchange of all wrong pairs, Newton's method and Lemke's path through friction work on
// different equations. They share where they begin, what they carry along, and how they end. An
// `Iterate` is what they carry: numbers, what these say of every pair, and a report.
//
// A start is good if it guesses which pairs close. Without contact forces a pair overlaps or it
// does not, and the pairs that overlap are the guess. For the three carts, d = (-2, -1, -3), these
// are all three.

#include "signorini/solvers/iterate.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "signorini/core/rounding.hpp"
#include "signorini/solvers/goldfarb_idnani.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

// Opens closed pairs without a force, if that is a solution as well: a pair that only touches holds
// nothing. One pair with d = 0 is solved by the force 0, whether it is called open or closed, and
// Newton's method comes to such a pair from either side. Without this, rounding would decide how
// many pairs are called closed.
void open_idle_pairs(const ScaledProblem& problem, Iterate& iterate) {
  const ActiveSetSolution& end = iterate.solution;
  std::vector<Index> pressed;
  for (const Index i : closed_pairs(iterate.statuses))
    if (end.force(i) > end.force_rounding) pressed.push_back(i);
  if (pressed.size() == end.rows.size()) return;
  if (Confirmed other = confirmed(problem, pressed, &end))
    std::tie(iterate.solution, iterate.statuses) = std::move(*other);
}

}  // namespace

// A method that does not arrive says why, and the user reads it. Where there is no new reason the
// last one stays.
void Iterate::stop(SolveStatus status, const char* why) {
  report.status = status;
  if (why != nullptr) reason = why;
}

// Two equal rows with d = (-1, -2) show why the order matters: the second one, closed with the force 2, leaves
// the first one the gap 1. The first one, closed with the force 1, would leave the second one an overlap of 1.
// With friction the set has rows of slips too, which no number of pairs puts in order.
ActiveSet surest_first(const ScaledProblem& problem, const std::vector<ContactStatus>& statuses,
                       const VectorXd& doubt) {
  ActiveSet set = active_set(statuses, problem.law);
  if (problem.law.pair.empty())
    std::stable_sort(set.closed.begin(), set.closed.end(),
                     [&](Index i, Index j) { return doubt(i) < doubt(j); });
  return set;
}

// Two kinds of problems need more than zero forces.
//
// *Friction.* Whether a pair sticks or slides depends on how hard it presses, and an overlap is a
// poor measure of a force. So the problem without friction is solved first, by goldfarb_idnani(),
// and its forces are the start. Where F has few entries this would cost more than it saves.
//
// *Rigid modes.* A body that only contact holds has no state of rest without contact. It starts
// from the smallest forces that balance its load, \f$ f = Ut \f$, with U orthonormal and
// \f$ U^Tf = t \f$. The amplitudes \f$ b = -U^T(d + Ff) \f$ make the sum of the squared gaps least.
// Two equal pairs under one body carry half of its load each.
//
// predict() then says what the numbers mean. The rounding of every movement is handed on with it,
// because a pair that touches at the start would otherwise be open or closed by chance.
Iterate first_iterate(const ScaledProblem& problem) {
  const Index pairs = problem.pairs();
  const MatrixXd& U = problem.rigid;
  Iterate iterate;
  ActiveSetSolution& now = iterate.solution;
  now.force.setZero(problem.free.size());
  now.amplitude.setZero(U.cols());
  double unit = force_scale(problem.compliance);
  if (U.cols() > 0) {
    unit = force_scale(problem, balanced_compliance(problem));
    now.force = U * problem.resultant;
    now.amplitude = -U.transpose() * (problem.free + problem.compliance * now.force);
  } else if (!problem.law.pair.empty() && problem.symmetric && problem.sparse.size() == 0) {
    const ContactState normal =
        goldfarb_idnani({problem.compliance.topLeftCorner(pairs, pairs), problem.free.head(pairs)});
    if (normal.report.status == SolveStatus::Solved) now.force.head(pairs) = normal.force;
  }
  now.movement = problem.free + problem.compliance * now.force;
  VectorXd size = problem.free.cwiseAbs() + problem.compliance.cwiseAbs() * now.force.cwiseAbs();
  if (U.cols() > 0) {
    now.movement += U * now.amplitude;
    size += U.cwiseAbs() * now.amplitude.cwiseAbs();
  }
  // A pair that touches is open until something presses it, whatever rounding says of its gap.
  now.movement_rounding = static_cast<double>(size.size() + U.cols() + 1) * epsilon * size;
  iterate.statuses = statuses_of({}, pairs);
  predict(problem, now, unit, iterate.statuses);
  return iterate;
}

// The statuses of a similar problem are all that is taken over. Its forces belong to another load.
Iterate iterate_from(const ScaledProblem& problem, const std::vector<ContactStatus>& statuses) {
  Iterate iterate;
  iterate.solution.force.setZero(problem.free.size());
  iterate.solution.movement = problem.free;
  iterate.solution.amplitude.setZero(problem.rigid.cols());
  iterate.statuses = statuses;
  return iterate;
}

// A method that only comes near a solution never arrives: a force may be 2.0000001 where it is 2. What
// the pairs do may be right long before. With G = 1 and d = -1 the force 0.93 has the gap -0.07: it exceeds
// the gap, the pair is taken as closed, and its equation says 1.
//
// The exact end from the statuses of an iterate, or from those which that end asks for: of a pair
// that touches without force, rounding decides the side. Two tries are made if F is symmetric: the
// end of the first is itself a step of the primal-dual active set. More tries would make this that
// method, which can cycle. If F is not symmetric one try is made. Of rows that repeat each other the one whose force
// exceeds its gap most is closed: the iterate is most certain of it.
bool ends_exactly(const ScaledProblem& problem, double force_scale, Iterate& iterate) {
  std::vector<ContactStatus> statuses = iterate.statuses;
  ActiveSetSolution start = iterate.solution;
  const bool frictional = !problem.law.pair.empty();
  if (!frictional) start.force.setZero();
  for (int trial = 0; trial < (problem.symmetric ? 2 : 1); ++trial) {
    const ActiveSet set = surest_first(
        problem, statuses, iterate.solution.movement - force_scale * iterate.solution.force);
    iterate.report.factorisations += set.closed.empty() ? 0 : 1;
    ActiveSetSolution end = solve_active_set(problem, set, &start);
    const std::vector<ContactStatus> closed =
        frictional ? statuses : statuses_of(end.rows, problem.pairs());
    if (solves(problem, closed, end)) {
      iterate.solution = std::move(end);
      iterate.statuses = closed;
      iterate.confirmed = true;
      if (!frictional) open_idle_pairs(problem, iterate);
      return true;
    }
    statuses = closed;
    if (!end.solvable || predict(problem, end, force_scale, statuses) == 0) return false;
  }
  return false;
}

// Only a confirmed end is called solved. The report may still carry the status of a problem that
// was solved on the way, such as one with another set of cohesive pairs.
ContactState finished(const ContactProblem& problem, const ScaledProblem& scaled, Iterate iterate) {
  Report& report = iterate.report;
  if (iterate.confirmed) {
    report.status = SolveStatus::Solved;
    iterate.reason.clear();
  } else if (report.status == SolveStatus::Solved) {
    report.status = SolveStatus::Breakdown;  // of another problem that was solved on the way
  }
  ContactState state =
      finished(problem, scaled, iterate.solution, iterate.statuses, std::move(report));
  if (state.reason.empty()) state.reason = std::move(iterate.reason);
  return state;
}

}  // namespace signorini

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
#include <utility>

#include "signorini/core/rounding.hpp"
#include "signorini/solvers/goldfarb_idnani.hpp"

namespace signorini {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A method that does not arrive says why, and the user reads it. Where there is no new reason the
// last one stays.
void Iterate::stop(SolveStatus status, const char* why) {
  report.status = status;
  if (why != nullptr) reason = why;
}

// A set without closed pairs needs no factorisation: its forces are known.
void Iterate::solve(const ScaledProblem& problem, const ActiveSet& set,
                    const ActiveSetSolution* start) {
  report.factorisations += set.closed.empty() ? 0 : 1;
  ++report.iterations;
  solution = solve_active_set(problem, set, start);
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
  double unit = force_scale(problem);
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

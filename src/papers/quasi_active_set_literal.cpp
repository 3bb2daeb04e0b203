// # The quasi-active set, as it is printed
//
// The loop of the paper: take pairs that overlap, close them as if there were no others, and look
// again. A step does not begin anew. It moves the point to the solution of these pairs, and the
// objective with it, so that the next step starts from where this one ended. Its forces are added
// to those before and are never taken back.
//
// Two things are wrong with that. The first: a set holds violated pairs only, so a pair that one step
// closes may be crossed by the next. A small problem shows it. Let
// \f[ G = \begin{pmatrix} 1 & -1 \\ -1 & 2 \end{pmatrix}, \qquad d = (-2, 1). \f]
// The first pair overlaps by 2. The force 2 closes it and pushes the second into an overlap of 1.
// The force 1/2 closes that one, and now the first overlaps by 1/2. The forces come to
//
//     step 1: 2       0
//     step 2: 2       1/2
//     step 3: 2 1/2   1/2
//     step 4: 2 1/2   3/4
//
// and so on towards (3, 1), which solves the problem and is never reached. If both pairs were
// closed together, one step would do. The second: forces are never taken back, even if later ones make
// them needless. [Chapter 4](../../chapters/ch04_quasi_active_set/README.md) has four walls for that, and
// proves when the loop ends.
//
// A second reading takes every pair at most once. Then the loop above ends after step 2, with forces
// (2, 1/2), and the first pair still overlaps by 1/2.
//
// This file is the loop of sections 2.3 and 3 of the paper, whose flow chart is lost in our copy. The sets of pairs and the problems with some pairs
// alone are in [literal_method.cpp](literal_method.cpp).

#include "papers/quasi_active_set_literal.hpp"

#include <algorithm>
#include <utility>

#include "papers/literal_method.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

// What a step presses are the pairs to which it gives a force.
std::vector<Index> pressed(const VectorXd& force) {
  std::vector<Index> rows;
  for (Index i = 0; i < force.size(); ++i)
    if (force(i) > 0) rows.push_back(i);
  return rows;
}

}  // namespace

// The dual energy never exceeds the least potential energy, so its history shows how far a run
// still is from its end.
void LiteralMethod::note(const ActiveSetSolution& point, Index overlapping) {
  const VectorXd gap = point.movement.cwiseQuotient(scaled_.scale);
  const double dual_energy = -0.5 * point.force.dot(scaled_.free + point.movement);
  report_.history.push_back({(point.force.array() > 0).count(), overlapping,
                             std::max(0.0, gap.size() > 0 ? -gap.minCoeff() : 0.0), 0,
                             dual_energy});
}

// With the moved objective the present gaps are the gaps without contact: that is all that (31)
// does. So every step solves the same kind of problem, with other numbers for d.
bool LiteralMethod::outer_loop() {
  for (ActiveSetSolution step;; ++way_.outer_steps) {
    const std::vector<Index> overlapping = violated(now_);
    note(now_, static_cast<Index>(overlapping.size()));
    const std::vector<Index> candidates = unused(overlapping);
    if (candidates.empty()) return true;
    if (way_.outer_steps == limit_) {
      report_.status = SolveStatus::IterationLimit;
      return false;
    }
    const std::vector<Index> rows = quasi_active(candidates);
    // (31): with the moved objective the free gaps are the present ones.
    if (!solve(rows, now_.movement, step)) return false;
    way_.steps.push_back({overlapping, rows, pressed(step.force)});
    for (const Index i : rows) used_[static_cast<std::size_t>(i)] = true;
    now_.force += step.force;  // (36)
    place(now_);
  }
}

// The objective has moved, so the end of the loop need not have the least energy. The paper solves
// once more with the first objective and the pairs that have no gap now, and goes towards that
// solution until the first pair would overlap.
bool LiteralMethod::last_step() {
  way_.tight = tight(now_);
  way_.moved = scaled_.scale.cwiseProduct(now_.force);
  ActiveSetSolution next;  // (33), with the first objective
  if (!solve(way_.tight, scaled_.free, next)) return false;
  place(next);
  way_.next = scaled_.scale.cwiseProduct(next.force);
  way_.optimal = close_to(next);
  way_.left_over = violated(next);
  for (const Index i : way_.left_over)  // (34)
    way_.fraction =
        std::min(way_.fraction, now_.movement(i) / (now_.movement(i) - next.movement(i)));
  now_.force += way_.fraction * (next.force - now_.force);  // (35)
  place(now_);
  note(now_, static_cast<Index>(violated(now_).size()));
  return true;
}

// The distance of two points is measured in energy. Its square is
// \f$ \Delta\lambda^T\,\Delta w \f$, for forces \f$ \lambda \f$ and gaps w.
bool LiteralMethod::close_to(const ActiveSetSolution& best) const {
  const double distance = (best.force - now_.force).dot(best.movement - now_.movement);  // squared
  const double energy = -0.5 * best.force.dot(scaled_.free + best.movement);
  return distance <= tolerance_ * energy;
}

// The paper calls the end optimal. Here it is tested: the pairs without gap are solved once more,
// alone. If that solution is where we stand, it is the solution of all. Otherwise the run says
// `Feasible`: no pair overlaps, and there is less energy elsewhere.
void LiteralMethod::judge() {
  if (pool_ == QuasiActivePool::UnusedPairs && !violated(now_).empty()) {
    report_.status = SolveStatus::IterationLimit;
    return;
  }
  report_.status = SolveStatus::Feasible;
  const Report so_far = report_;
  ActiveSetSolution best;
  if (!solve(tight(now_), scaled_.free, best)) {
    report_ = so_far;
    way_.state.farkas_certificate.resize(0);
    return;
  }
  report_ = so_far;
  place(best);
  if (!violated(best).empty() || !close_to(best)) return;
  auto found = confirmed(scaled_, pressed(best.force));
  report_.status = found ? SolveStatus::Solved : SolveStatus::Breakdown;
  if (found) {
    now_ = std::move(found->first);
    way_.state.contact_status = std::move(found->second);
  }
}

// The flow chart in one line: the loop, the last step, the verdict.
QuasiActiveRun LiteralMethod::run() {
  if (outer_loop() && last_step()) judge();
  report_.iterations = static_cast<Index>(report_.history.size());
  const std::vector<Index> closed =
      report_.status == SolveStatus::Solved ? way_.state.active() : pressed(now_.force);
  way_.state = finished(problem_, scaled_, now_, statuses_of(closed, now_.force.size()),
                        std::move(report_), std::move(way_.state.farkas_certificate));
  return std::move(way_);
}

QuasiActiveRun run_quasi_active_set_literal(const ContactProblem& problem,
                                            const SolverOptions& options, QuasiActiveRows rows,
                                            QuasiActivePool pool) {
  check_plain(problem, "quasi_active_set_literal");
  return LiteralMethod(problem, options, rows, pool).run();
}

ContactState quasi_active_set_literal(const ContactProblem& problem, const SolverOptions& options) {
  return run_quasi_active_set_literal(problem, options).state;
}

// Forces that balance the load and never pull give a lower bound of the energy. Its distance from
// the energy at hand is the work of the forces on the gaps.
double energy_gap(const ContactState& state) { return state.force.dot(state.gap); }

}  // namespace signorini

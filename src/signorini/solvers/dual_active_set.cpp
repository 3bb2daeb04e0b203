// # Dual active sets
//
// The forces of contact make the dual energy \f$ -d^T\lambda - \tfrac12\lambda^TG\lambda \f$ as
// large as forces \f$ \lambda \ge 0 \f$ can. A dual active set method climbs. It keeps a set W of
// closed pairs that all press, \f$ G_{WW}\lambda_W = -d_W \f$ with \f$ \lambda_W \ge 0 \f$, and
// lets pairs join that overlap. Forces are the best for their set at each stage, and the energy
// rises from stage to stage. So no set comes back, and there are finitely many. An active set that
// exchanges all wrong pairs at once has no such number that rises, and it can cycle.
//
// A set may grow in two ways. A *single* step presses the pair that overlaps most until it closes,
// as Goldfarb and Idnani (1983) do. A *block* step closes a group of pairs together, which is the
// idea of Xuan and Li (2002), and opens those that would pull.
//
// The three carts, G = [1 1 1; 1 2 2; 1 2 3] and d = (-2, -1, -3), need one block. All three
// overlap. A pair that joins first adds \f$ d_i^2 / (2G_{ii}) \f$ to the energy: 2, 1/4 and 3/2, so
// pair 1 is taken, with the force 2. That opens the gap of pair 2 to 1 and leaves pair 3 an overlap
// of 1. Pair 3 joins with 0.5, pair 1 yields to 1.5, and the energy is 9/4. Pair 2 is never closed.
//
// This file has the loop and the block; [dual_active_set_steps.cpp](dual_active_set_steps.cpp) has
// the single steps. L with \f$ LL^T = G_{WW} \f$ is kept in an
// [ActiveSetFactor](../problem/active_set_factor.hpp), which grows and shrinks by one row. With
// \f$ y = -L^{-1}d_W \f$ the energy is \f$ \tfrac12|y|^2 \f$. A row that joins adds one entry to y,
// so that its gain is known before it joins.

#include "signorini/solvers/dual_active_set.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Whether one energy is larger than another beyond rounding. Energies are sums of squares. Two that
// differ by their rounding count as equal. Otherwise rows that only change places would seem to
// raise the energy, and they could do so for ever.
bool rises(double now, double before, Index size) {
  return now > before * (1 + static_cast<double>(size + 1) * epsilon);
}

}  // namespace

// A block holds at most half as many rows as can be independent. At first no row is closed.
DualActiveSet::DualActiveSet(const ConstraintRows& rows, ActiveSetFactor basis, Report& report,
                             Index limit, Step kind)
    : rows_(rows),
      basis_(std::move(basis)),
      saved_(0, 0),
      report_(report),
      limit_(limit),
      kind_(kind),
      group_((rows.rank + 1) / 2),
      force_(basis_.capacity()),
      state_(at(rows.count), Row::Open) {
  for (const Index row : basis_.rows()) state_[at(row)] = Row::Closed;
  report_.history.reserve(8);
  candidates_.rows.reserve(at(rows.count));
}

// The forces that would close all pairs of the basis. They are only a target, because some of them
// may pull. It costs one triangular solve, and the report counts it as a factorisation.
void DualActiveSet::solve() {
  basis_.solve(target_);
  ++report_.factorisations;
}

// Positions of the basis whose new force is not positive. Equations may pull.
std::vector<Index> DualActiveSet::pulling() const {
  std::vector<Index> positions;
  for (Index k = 0; k < basis_.size(); ++k)
    if (target_(k) <= 0 && basis_.rows()[at(k)] >= rows_.equations) positions.push_back(k);
  return positions;
}

// To open a row takes it out of the factor and changes its state.
void DualActiveSet::drop(const std::vector<Index>& positions) {
  for (const Index k : positions) state_[at(basis_.rows()[at(k)])] = Row::Open;
  basis_.remove(positions);
}

// A row that is pressed alone needs its products with the basis and no others.
void DualActiveSet::fetch(Index row) {
  candidates_.rows.assign(1, row);
  rows_.fetch(basis_, gap_, rounding_, candidates_);
}

// Equations are rows that are always closed, with forces of any sign. They join before all others.
// One that depends on the others either follows from them, and its gap is zero too, or it
// contradicts them, and nothing solves the problem.
SolveStatus DualActiveSet::close_equations() {
  candidates_.rows.resize(at(rows_.equations));
  std::iota(candidates_.rows.begin(), candidates_.rows.end(), Index{0});
  for (const Index row : candidates_.rows) state_[at(row)] = Row::Closed;
  rows_.gaps(basis_, gap_, rounding_);
  rows_.fetch(basis_, gap_, rounding_, candidates_);
  basis_.append(candidates_, ActiveSetFactor::Choice::All, rows_.equations);
  solve();
  force_.head(basis_.size()) = target_.head(basis_.size());
  for (Index i = 0; i < rows_.equations; ++i) {
    if (std::abs(candidates_.gap(i)) <= 4 * candidates_.rounding(i)) continue;
    // Row i depends on those that joined, and its own right side contradicts theirs.
    const double sign = candidates_.gap(i) < 0 ? 1 : -1;
    fetch(i);
    proof_.setZero(rows_.count);
    const VectorXd response = basis_.response(candidates_).yield;
    for (Index k = 0; k < response.size(); ++k) proof_(basis_.rows()[at(k)]) = -sign * response(k);
    proof_(i) = sign;
    return SolveStatus::Infeasible;
  }
  return SolveStatus::Solved;
}

// Violated rows, the worst first, at most twice as many as may join. Each candidate costs products
// with the basis, so there are no more than that. Overlaps of rows of different length are compared
// by their weight. The history gets its entry here, where the gaps of all rows are known.
void DualActiveSet::find_most_violated() {
  std::vector<Index>& violated = candidates_.rows;
  violated.clear();
  double overlap = 0;
  for (Index i = rows_.equations; i < rows_.count; ++i) {
    if (gap_(i) >= -rounding_(i) || state_[at(i)] == Row::Closed) continue;
    overlap = std::max(overlap, -gap_(i) / (rows_.unit != nullptr ? (*rows_.unit)(i) : 1));
    if (state_[at(i)] == Row::Open) violated.push_back(i);
  }
  report_.history.push_back(
      {basis_.size(), static_cast<Index>(violated.size()), overlap, 0, basis_.dual_energy()});
  const VectorXd& weight = *rows_.weight;
  const auto worse = [&](Index a, Index b) {
    const double first = gap_(a) * weight(a);
    const double second = gap_(b) * weight(b);
    return first < second || (first == second && a < b);
  };
  const std::size_t most = std::min(violated.size(), at(2 * group_));
  std::partial_sort(violated.begin(), violated.begin() + static_cast<std::ptrdiff_t>(most),
                    violated.end(), worse);
  violated.resize(most);
}

// The loop. Candidates that are independent of the closed pairs join as a block. If none is
// independent, the worst is pressed alone, while others leave for it.
//
// In exact numbers the energy rises each time. With rounding, rows that are nearly equal can
// replace each other without a rise, and for ever. So rows that joined or left without a rise are
// called *stalled* and are passed over until the energy rises again.
SolveStatus DualActiveSet::run() {
  double highest = basis_.dual_energy();
  while (true) {
    rows_.gaps(basis_, gap_, rounding_);
    find_most_violated();
    if (candidates_.rows.empty()) return SolveStatus::Solved;
    if (report_.iterations >= limit_) return SolveStatus::IterationLimit;
    const Index before = basis_.size();
    const std::vector<Index> closed = basis_.rows();
    const Index worst = candidates_.rows.front();
    SolveStatus status = SolveStatus::Solved;
    if (kind_ == Step::Single) {
      candidates_.rows.resize(1);
      status = press(worst);
    } else {
      rows_.fetch(basis_, gap_, rounding_, candidates_);
      if (basis_.append(candidates_, ActiveSetFactor::Choice::Violated, group_) > 0) {
        ++report_.iterations;
        settle(before);
      } else {
        status = press(worst);
      }
    }
    if (status != SolveStatus::Solved) return status;
    if (rises(basis_.dual_energy(), highest, basis_.size())) {
      highest = basis_.dual_energy();
      forget_stalled();
    } else {  // rows that only change places, as nearly equal ones do, must not do so for ever
      mark_stalled(candidates_.rows);
      mark_stalled(closed);
    }
  }
}

// Solves with the rows that joined at position `before` and behind, and drops until no force pulls.
// Dropping all pairs that pull at once is fast, and it may drop too many. The energy says so: if it
// is no larger than before the block, the block was too bold. Then the method goes back to the
// forces before it, and moves to the new ones step by step.
void DualActiveSet::settle(Index before) {
  for (Index k = before; k < basis_.size(); ++k) state_[at(basis_.rows()[at(k)])] = Row::Closed;
  solve();
  std::vector<Index> negative = pulling();
  if (!negative.empty()) {
    saved_ = basis_;
    const double energy = 0.5 * basis_.coordinates().head(before).squaredNorm();
    while (!negative.empty()) {
      drop(negative);
      solve();
      negative = pulling();
    }
    if (!rises(basis_.dual_energy(), energy, basis_.size())) {  // too bold: back, and step by step
      std::swap(basis_, saved_);
      for (const Index row : basis_.rows()) state_[at(row)] = Row::Closed;
      force_.segment(before, basis_.size() - before).setZero();
      step_by_step();
      return;
    }
  }
  force_.head(basis_.size()) = target_.head(basis_.size());
}

// A refined solution may find that a closed pair pulls where the updated factor found that it
// presses. Such a pair opens here. What had stalled is looked at again, because the forces are new
// ones.
void DualActiveSet::release(const VectorXd& tension) {
  std::vector<Index> positions;
  for (Index k = 0; k < tension.size(); ++k)
    if (tension(k) > 0) positions.push_back(k);
  do {
    drop(positions);
    solve();
    positions = pulling();
  } while (!positions.empty());
  force_.head(basis_.size()) = target_.head(basis_.size());
  forget_stalled();
}

// A proof that does not hold was rounding, and so was the overlap of its row.
void DualActiveSet::pass_over() { mark_stalled({pressed_}); }

// Marks the rows of a list that are open. Closed ones keep their state, because a row that is
// stalled is not closed.
void DualActiveSet::mark_stalled(const std::vector<Index>& rows) {
  for (const Index row : rows)
    if (state_[at(row)] == Row::Open) state_[at(row)] = Row::Stalled;
}

// Once the energy has risen, no earlier set can come back, and no row need be passed over.
void DualActiveSet::forget_stalled() {
  std::replace(state_.begin(), state_.end(), Row::Stalled, Row::Open);
}

}  // namespace signorini

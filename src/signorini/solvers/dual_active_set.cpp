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
// This file has the loop. Beside it stand the [single step](dual_active_set_steps.cpp), the
// [block](dual_active_set_blocks.cpp), and what is done about
// [rows that depend on others](dual_active_set_rounding.cpp). L with \f$ LL^T = G_{WW} \f$ is kept
// in an [ActiveSetFactor](../problem/active_set_factor.hpp), which grows and shrinks by one row.
// With \f$ y = -L^{-1}d_W \f$ the energy is \f$ \tfrac12|y|^2 \f$. A row that joins adds one
// entry to y, so that its gain is known before it joins.

#include "signorini/solvers/dual_active_set.hpp"

#include <algorithm>
#include <utility>

#include "signorini/core/index.hpp"

namespace signorini {

using Eigen::Index, Eigen::VectorXd;

// Rows that are closed already are those of the basis.
DualActiveSet::DualActiveSet(const ConstraintRows& rows, ActiveSetFactor basis, Report& report,
                             Index limit, Step kind)
    : rows_(rows), basis_(std::move(basis)), report_(report), limit_(limit), kind_(kind) {
  state_.assign(at(rows.count), Row::Open);
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
    const double first = gap_(a) * weight(a), second = gap_(b) * weight(b);
    return first < second || (first == second && a < b);
  };
  const std::size_t most = std::min(violated.size(), at(2 * group_));
  std::partial_sort(violated.begin(), violated.begin() + static_cast<std::ptrdiff_t>(most),
                    violated.end(), worse);
  violated.resize(most);
}

// The loop. Where blocks are allowed, candidates that are independent of the closed pairs join as
// one block. If none is independent, and in single steps always, the worst is pressed alone, while others
// leave for it.
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
    const std::vector<Index> closed = basis_.rows();
    if (kind_ == Step::Single || !close_block()) {
      const SolveStatus status = press(candidates_.rows.front());
      if (status != SolveStatus::Solved) return status;
    }
    if (energy_exceeds(highest)) {
      highest = basis_.dual_energy();
      forget_stalled();
    } else {  // rows that only change places, as nearly equal ones do, must not do so for ever
      mark_stalled(candidates_.rows);
      mark_stalled(closed);
    }
  }
}

}  // namespace signorini

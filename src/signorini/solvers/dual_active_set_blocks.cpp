// # Dual active sets, in blocks
//
// A group of pairs closes together, \f$ \lambda_W = -G_{WW}^{-1}d_W \f$, and those whose force
// pulls open together, until none pulls. That is bold: pairs that join at once may push each other
// out. The dual energy judges it, for it must rise. If it does not, the method goes back to the
// forces before the block, and walks from there towards the new ones.
//
// G = [3 2 2; 2 2 1; 2 1 2] with d = (-9, -7, -7), two pairs at a time: the first block closes pairs
// 1 and 2 with the forces 2 and 3/2, and pair 3 overlaps by 3/2. The second block adds pair 3, and
// the forces are (-1, 3, 3). Pair 1 pulls and opens. The others press with 7/3 each, the gap of pair
// 1 is 1/3, and the energy has risen from 57/4 to 49/3: the block stands.

#include <algorithm>

#include "signorini/core/index.hpp"
#include "signorini/solvers/dual_active_set.hpp"

namespace signorini {

using Eigen::Index, Eigen::VectorXd;

// Candidates that are independent of the closed pairs and of each other join, those with the
// largest gain of energy first, at most half as many as can be independent in all.
// \return false if there are none
bool DualActiveSet::close_block() {
  const Index before = basis_.size();
  rows_.fetch(basis_, gap_, rounding_, candidates_);
  if (basis_.append(candidates_, ActiveSetFactor::Choice::Violated, group_) == 0) return false;
  ++report_.iterations;
  settle(before);
  return true;
}

// Positions of the basis whose new force is not positive. Equations may pull.
std::vector<Index> DualActiveSet::pulling() const {
  std::vector<Index> positions;
  for (Index k = 0; k < basis_.size(); ++k)
    if (target_(k) <= 0 && basis_.rows()[at(k)] >= rows_.equations) positions.push_back(k);
  return positions;
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
    if (!energy_exceeds(energy)) {  // too bold: back, and step by step
      std::swap(basis_, saved_);
      for (const Index row : basis_.rows()) state_[at(row)] = Row::Closed;
      force_.segment(before, basis_.size() - before).setZero();
      step_by_step();
      return;
    }
  }
  force_.head(basis_.size()) = target_.head(basis_.size());
}

// Moves from forces that do not pull towards the best for all closed rows; where a force vanishes
// first, its row opens and the target changes. The dual energy rises all the way. The energy is
// concave, so it rises along the whole line to its largest value on the set. The line may be left
// early at no loss.
void DualActiveSet::step_by_step() {
  while (true) {
    solve();
    const std::vector<Index> negative = pulling();
    if (negative.empty()) break;
    const auto share = [&](Index k) {
      return force_(k) > 0 ? force_(k) / (force_(k) - target_(k)) : 0.0;
    };
    double step = 1;
    for (const Index k : negative) step = std::min(step, share(k));
    std::vector<Index> vanished;
    for (const Index k : negative)
      if (share(k) <= step) vanished.push_back(k);
    const Index size = basis_.size();
    force_.head(size) += step * (target_.head(size) - force_.head(size));
    open_vanished(vanished);
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

}  // namespace signorini

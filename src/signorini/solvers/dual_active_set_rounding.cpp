// # Dual active sets, and rows that depend on others
//
// A pair p that depends on the closed pairs W is pressed and does not open: a = 0. If no pair leaves
// for it, forces can grow for ever along (-r, 1) and move nothing. Then nothing solves the problem,
// and these numbers are the proof. G = [1 -1; -1 1] with d = (-1, -1) is a body between two walls
// that are too close. Pair 1 is closed with the force 1, the gap of pair 2 is -2, and r = -1: the
// proof is (1, 1).
//
// That is so in exact numbers. With rounding a pair may seem to overlap that only touches, and an
// energy may seem to rise that only wavers. This file has what is done about both, and the
// equations, which may depend on each other as well.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/solvers/dual_active_set.hpp"

namespace signorini {

using Eigen::Index, Eigen::VectorXd;

// Energies are sums of squares. Two that differ by their rounding count as equal. Otherwise rows
// that only change places would seem to raise the energy, and they could do so for ever.
bool DualActiveSet::energy_exceeds(double energy) const {
  const auto terms = static_cast<double>(basis_.size() + 1);
  return basis_.dual_energy() > energy * (1 + terms * epsilon);
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

// How much overlap of a row that depends on the closed ones can be rounding, its own or theirs. The
// gap of such a row is a sum of theirs with the weights r, and so is its rounding.
double DualActiveSet::grazing(Index row, const VectorXd& response) const {
  const double distance = basis_.smallest_distance();
  const double weight = (*rows_.weight)(row);
  double rounding = rounding_(row);
  for (Index k = 0; k < basis_.size() && weight > 0; ++k) {
    const Index closed = basis_.rows()[at(k)];
    rounding += std::abs(response(k)) * rounding_(closed) * (*rows_.weight)(closed) / weight;
  }
  return std::max(2 * rounding, rounding_(row) / epsilon * distance * distance);
}

// No force vanishes when a row is pressed that depends on the closed ones. That is the proof,
// unless the overlap is rounding. Entries of the proof that belong to equations may have any sign.
SolveStatus DualActiveSet::cannot_close(Index row, const VectorXd& response) {
  if (-gap_(row) <= grazing(row, response)) {  // it only touches, as far as rounding can tell
    mark_stalled({row});
    return SolveStatus::Solved;
  }
  proof_.setZero(rows_.count);
  for (Index k = 0; k < basis_.size(); ++k) {
    const Index closed = basis_.rows()[at(k)];
    proof_(closed) = closed < rows_.equations ? -response(k) : std::max(0.0, -response(k));
  }
  proof_(row) = 1;
  pressed_ = row;
  return SolveStatus::Infeasible;
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

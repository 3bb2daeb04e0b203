// # Dual active sets, step by step
//
// Pairs W are closed and press. One more pair p overlaps and is to close. If its force grows by 1
// and W stays closed, the forces of W change by -r and the gap of p by a,
// \f[ r = G_{WW}^{-1}G_{Wp}, \qquad a = G_{pp} - G_{pW}\,r \ge 0. \f]
// p closes when its force has grown by \f$ -g_p/a \f$. On the way the force of a pair of W may
// vanish, first where \f$ \lambda_k/r_k \f$ is least among \f$ r_k > 0 \f$. That pair opens, r and
// a are computed for the smaller set, and the pressing goes on. No force becomes negative, and the
// energy rises all the way.
//
// The carts, G = [1 1 1; 1 2 2; 1 2 3] with cart 1 closed by the force 2: cart 3 overlaps by 1.
// Here r = 1 and a = 3 - 1 = 2. It closes at the force 1/2, before the force of cart 1 would vanish
// at 2. The forces are (1.5, 0, 0.5).
//
// If p depends on W, a is 0: pressing p does not open its gap. Either a pair leaves, or r has no
// positive entry. In the second case forces may grow for ever along (-r, 1) and move nothing. Then
// nothing solves the problem, and these numbers are the proof. G = [1 -1; -1 1] with d = (-1, -1)
// is a body between two walls that are too close. Pair 1 is closed with the force 1, the gap of
// pair 2 is -2, and r = -1: the proof is (1, 1).

#include <algorithm>
#include <cmath>
#include <utility>

#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/solvers/dual_active_set.hpp"

namespace signorini {

using Eigen::Index;
using Eigen::VectorXd;

// Drops rows and their entries in the forces.
void DualActiveSet::open_vanished(const std::vector<Index>& positions) {
  for (auto k = positions.rbegin(); k != positions.rend(); ++k)
    for (Index i = *k + 1; i < force_.size(); ++i) force_(i - 1) = force_(i);
  drop(positions);
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

// The closed row whose force vanishes first when the forces change by -response, and the step to
// there; -1 if none does. A response so small that without this row the new one would still depend
// on the others is rounding. A pair that left for such a response would leave a set behind that is
// singular with the new pair.
std::pair<Index, double> DualActiveSet::first_to_open(const VectorXd& response) const {
  std::vector<Index> yielding;
  for (Index k = 0; k < basis_.size(); ++k)
    if (response(k) > 0 && basis_.rows()[at(k)] >= rows_.equations) yielding.push_back(k);
  const auto step = [&](Index k) { return force_(k) / response(k); };
  std::sort(yielding.begin(), yielding.end(),
            [&](Index a, Index b) { return step(a) < step(b) || (step(a) == step(b) && a < b); });
  for (const Index k : yielding)
    if (response(k) * basis_.distance_from_others(k) > basis_.smallest_distance())
      return {k, step(k)};
  return {-1, 0};
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

// Closes a row that carries a force already. \return false if it depends on the closed ones The
// factor takes the row with its present gap, so the gaps are computed first.
bool DualActiveSet::join(Index row, double force) {
  rows_.gaps(basis_, gap_, rounding_);
  fetch(row);
  if (basis_.append(candidates_, ActiveSetFactor::Choice::All, 1) == 0) return false;
  force_(basis_.size() - 1) = force;
  state_[at(row)] = Row::Closed;
  return true;
}

// Changes the forces of the closed rows by -step * response. Rounding may leave those of rows that
// yield faster than the first to open a little below zero.
void DualActiveSet::yield(const VectorXd& response, double step) {
  force_.head(basis_.size()) -= step * response;
  for (Index k = 0; k < basis_.size(); ++k)
    if (basis_.rows()[at(k)] >= rows_.equations) force_(k) = std::max(0.0, force_(k));
}

// The step of Goldfarb and Idnani. A pair is pressed through as many sets as it takes. The opening
// of its gap is summed up, because the factor knows the gap only for the forces of the basis.
// [press]
/// Presses a violated row until it closes; closed rows whose force vanishes on the way open.
SolveStatus DualActiveSet::press(Index row) {
  double pressed = 0;
  double lifted = 0;  // of the gap of the normalised row
  while (report_.iterations < limit_) {
    fetch(row);
    const double gap = candidates_.gap(0) + lifted;
    const auto [response, opening] = basis_.response(candidates_);
    const auto [first, step] = first_to_open(response);
    const bool closes = opening > 0 && (first < 0 || -gap <= step * opening);
    if (!closes && first < 0) return cannot_close(row, response);
    const double change = closes ? -gap / opening : step;
    yield(response, change);
    pressed += change;
    ++report_.iterations;
    if (closes) {
      if (!join(row, pressed)) return SolveStatus::Breakdown;
      basis_.solve(target_);  // by a factor that is only updated
      force_.head(basis_.size()) = target_.head(basis_.size());
      return SolveStatus::Solved;
    }
    lifted += change * opening;
    open_vanished({first});
  }
  return SolveStatus::IterationLimit;
}
// [press]

// A caller that chooses the row itself, as the faces of the simplex in
// [simplex_face.cpp](../../papers/simplex_face.cpp) do.
SolveStatus DualActiveSet::take_in(Index row) {
  rows_.gaps(basis_, gap_, rounding_);
  return press(row);
}

}  // namespace signorini

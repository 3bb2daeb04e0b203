// What a group of pairs does step by step: where a force vanishes on the way, its pair opens.
#include <algorithm>
#include <cmath>
#include <utility>

#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/solvers/dual_active_set.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

}  // namespace

/// Drops rows and their entries in the forces.
void DualActiveSet::open_vanished(const std::vector<Index>& positions) {
  for (auto k = positions.rbegin(); k != positions.rend(); ++k)
    for (Index i = *k + 1; i < force_.size(); ++i) force_(i - 1) = force_(i);
  drop(positions);
}

/// Moves from forces that do not pull towards the best for all closed rows; where a force vanishes
/// first, its row opens and the target changes. The dual energy rises all the way.
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

/// The closed row whose force vanishes first when the forces change by -response, and the step to there; -1
/// if none does. A response so small that without this row the new one would still depend on the others
/// is rounding.
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

/// How much overlap of a row that depends on the closed ones can be rounding, its own or theirs.
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

/// No force vanishes when a row is pressed that depends on the closed ones.
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

/// Closes a row that carries a force already. \return false if it depends on the closed ones
bool DualActiveSet::join(Index row, double force) {
  rows_.gaps(basis_, gap_, rounding_);
  fetch(row);
  if (basis_.append(candidates_, ActiveSetFactor::Choice::All, 1) == 0) return false;
  force_(basis_.size() - 1) = force;
  state_[at(row)] = Row::Closed;
  return true;
}

/// Changes the forces of the closed rows by -step * response. Rounding may leave those of rows that yield faster
/// than the first to open a little below zero.
void DualActiveSet::yield(const VectorXd& response, double step) {
  force_.head(basis_.size()) -= step * response;
  for (Index k = 0; k < basis_.size(); ++k)
    if (basis_.rows()[at(k)] >= rows_.equations) force_(k) = std::max(0.0, force_(k));
}

/// A violated row depends on the closed ones: presses it, while they yield, until the first one opens.
SolveStatus DualActiveSet::exchange(Index row) {
  fetch(row);
  const VectorXd response = basis_.response(candidates_).yield;
  const auto [first, step] = first_to_open(response);
  if (first < 0) return cannot_close(row, response);
  yield(response, step);
  open_vanished({first});
  if (!join(row, step)) return SolveStatus::Breakdown;
  step_by_step();
  return SolveStatus::Solved;
}

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

SolveStatus DualActiveSet::take_in(Index row) {
  rows_.gaps(basis_, gap_, rounding_);
  return press(row);
}

}  // namespace signorini

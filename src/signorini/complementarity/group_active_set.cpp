#include "signorini/complementarity/group_active_set.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "signorini/complementarity/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// Whether one energy is larger than another beyond rounding.
bool rises(double now, double before, Index size) {
  return now > before * (1 + static_cast<double>(size + 1) * epsilon);
}

}  // namespace

GroupActiveSet::GroupActiveSet(const GapRows& rows, ClosedBasis basis, Report& report, Index limit)
    : rows_(rows),
      basis_(std::move(basis)),
      saved_(0, 0),
      report_(report),
      limit_(limit),
      group_((rows.rank + 1) / 2),
      force_(basis_.capacity()),
      state_(at(rows.count), Row::Open) {
  report_.history.reserve(8);
  candidates_.rows.reserve(at(rows.count));
}

void GroupActiveSet::solve() {
  basis_.solve(target_);
  ++report_.factorisations;
}

/// Positions of the basis whose new force is not positive.
std::vector<Index> GroupActiveSet::pulling() const {
  std::vector<Index> positions;
  for (Index k = 0; k < basis_.size(); ++k)
    if (target_(k) <= 0 && basis_.rows()[at(k)] >= rows_.equations) positions.push_back(k);
  return positions;
}

void GroupActiveSet::drop(const std::vector<Index>& positions) {
  for (const Index k : positions) state_[at(basis_.rows()[at(k)])] = Row::Open;
  basis_.remove(positions);
}

void GroupActiveSet::fetch(Index row) {
  candidates_.rows.assign(1, row);
  rows_.fetch(basis_, gap_, rounding_, candidates_);
}

Status GroupActiveSet::close_equations() {
  candidates_.rows.resize(at(rows_.equations));
  std::iota(candidates_.rows.begin(), candidates_.rows.end(), Index{0});
  for (const Index row : candidates_.rows) state_[at(row)] = Row::Closed;
  rows_.gaps(basis_, gap_, rounding_);
  rows_.fetch(basis_, gap_, rounding_, candidates_);
  basis_.append(candidates_, ClosedBasis::Choice::All, rows_.equations);
  solve();
  force_.head(basis_.size()) = target_.head(basis_.size());
  for (Index i = 0; i < rows_.equations; ++i) {
    if (std::abs(candidates_.gap(i)) <= 4 * candidates_.rounding(i)) continue;
    // Row i depends on those that joined, and its own right side contradicts theirs.
    const double sign = candidates_.gap(i) < 0 ? 1 : -1;
    fetch(i);
    proof_.setZero(rows_.count);
    const VectorXd response = basis_.response(candidates_);
    for (Index k = 0; k < response.size(); ++k) proof_(basis_.rows()[at(k)]) = -sign * response(k);
    proof_(i) = sign;
    return Status::Infeasible;
  }
  return Status::Solved;
}

/// Violated rows, the worst first, at most twice as many as may join.
void GroupActiveSet::find_most_violated() {
  std::vector<Index>& violated = candidates_.rows;
  violated.clear();
  double overlap = 0;
  for (Index i = rows_.equations; i < rows_.count; ++i) {
    if (gap_(i) >= -rounding_(i) || state_[at(i)] == Row::Closed) continue;
    overlap = std::max(overlap, -gap_(i));
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

Status GroupActiveSet::run() {
  while (true) {
    rows_.gaps(basis_, gap_, rounding_);
    find_most_violated();
    if (candidates_.rows.empty()) return Status::Solved;
    if (report_.iterations >= limit_) return Status::IterationLimit;
    ++report_.iterations;
    const Index before = basis_.size();
    const double energy = basis_.dual_energy();
    const Index worst = candidates_.rows.front();
    rows_.fetch(basis_, gap_, rounding_, candidates_);
    if (basis_.append(candidates_, ClosedBasis::Choice::Violated, group_) > 0) {
      settle(before);
    } else {
      const Status status = exchange(worst);
      if (status != Status::Solved) return status;
    }
    if (rises(basis_.dual_energy(), energy, basis_.size())) {
      forget_fruitless();
    } else {
      for (const Index row : candidates_.rows)
        if (state_[at(row)] == Row::Open) {
          state_[at(row)] = Row::Fruitless;
          any_fruitless_ = true;
        }
    }
  }
}

/// Solves with the rows that joined at position `before` and behind, and drops until no force pulls.
void GroupActiveSet::settle(Index before) {
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

/// Drops rows and their entries in the forces.
void GroupActiveSet::open_vanished(const std::vector<Index>& positions) {
  for (auto k = positions.rbegin(); k != positions.rend(); ++k)
    for (Index i = *k + 1; i < force_.size(); ++i) force_(i - 1) = force_(i);
  drop(positions);
}

/// Moves from forces that do not pull towards the best for all closed rows; where a force vanishes
/// first, its row opens and the target changes. The dual energy rises all the way.
void GroupActiveSet::step_by_step() {
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
std::pair<Index, double> GroupActiveSet::first_to_open(const VectorXd& response) const {
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
double GroupActiveSet::grazing(Index row, const VectorXd& response) const {
  const double distance = basis_.smallest_distance();
  const double weight = (*rows_.weight)(row);
  double rounding = rounding_(row);
  for (Index k = 0; k < basis_.size() && weight > 0; ++k) {
    const Index closed = basis_.rows()[at(k)];
    rounding += std::abs(response(k)) * rounding_(closed) * (*rows_.weight)(closed) / weight;
  }
  return std::max(2 * rounding, rounding_(row) / epsilon * distance * distance);
}

/// A violated row depends on the closed ones: presses it, while they yield, until the first one opens.
Status GroupActiveSet::exchange(Index row) {
  fetch(row);
  const VectorXd response = basis_.response(candidates_);
  const Index size = basis_.size();
  const auto [first, press] = first_to_open(response);
  if (first < 0) {
    if (-gap_(row) <= grazing(row, response)) {  // it only touches, as far as rounding can tell
      state_[at(row)] = Row::Fruitless;
      any_fruitless_ = true;
      return Status::Solved;
    }
    proof_.setZero(rows_.count);
    for (Index k = 0; k < size; ++k) {
      const Index closed = basis_.rows()[at(k)];
      proof_(closed) = closed < rows_.equations ? -response(k) : std::max(0.0, -response(k));
    }
    proof_(row) = 1;
    return Status::Infeasible;
  }
  // Rounding may leave forces of rows that yield faster a little below zero.
  force_.head(size) -= press * response;
  for (Index k = 0; k < size; ++k)
    if (basis_.rows()[at(k)] >= rows_.equations) force_(k) = std::max(0.0, force_(k));
  open_vanished({first});
  rows_.gaps(basis_, gap_, rounding_);
  fetch(row);
  if (basis_.append(candidates_, ClosedBasis::Choice::All, 1) == 0) return Status::Breakdown;
  force_(size - 1) = press;
  state_[at(row)] = Row::Closed;
  step_by_step();
  return Status::Solved;
}

void GroupActiveSet::release(const VectorXd& tension) {
  std::vector<Index> positions;
  for (Index k = 0; k < tension.size(); ++k)
    if (tension(k) > 0) positions.push_back(k);
  do {
    drop(positions);
    solve();
    positions = pulling();
  } while (!positions.empty());
  force_.head(basis_.size()) = target_.head(basis_.size());
  forget_fruitless();
}

void GroupActiveSet::forget_fruitless() {
  if (any_fruitless_) std::replace(state_.begin(), state_.end(), Row::Fruitless, Row::Open);
  any_fruitless_ = false;
}

}  // namespace signorini

#include "signorini/solvers/dual_active_set.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Whether one energy is larger than another beyond rounding.
bool rises(double now, double before, Index size) {
  return now > before * (1 + static_cast<double>(size + 1) * epsilon);
}

}  // namespace

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
  report_.history.reserve(8);
  candidates_.rows.reserve(at(rows.count));
}

void DualActiveSet::solve() {
  basis_.solve(target_);
  ++report_.factorisations;
}

/// Positions of the basis whose new force is not positive.
std::vector<Index> DualActiveSet::pulling() const {
  std::vector<Index> positions;
  for (Index k = 0; k < basis_.size(); ++k)
    if (target_(k) <= 0 && basis_.rows()[at(k)] >= rows_.equations) positions.push_back(k);
  return positions;
}

void DualActiveSet::drop(const std::vector<Index>& positions) {
  for (const Index k : positions) state_[at(basis_.rows()[at(k)])] = Row::Open;
  basis_.remove(positions);
}

void DualActiveSet::fetch(Index row) {
  candidates_.rows.assign(1, row);
  rows_.fetch(basis_, gap_, rounding_, candidates_);
}

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

/// Violated rows, the worst first, at most twice as many as may join.
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

SolveStatus DualActiveSet::run() {
  double highest = basis_.dual_energy();
  while (true) {
    rows_.gaps(basis_, gap_, rounding_);
    find_most_violated();
    if (candidates_.rows.empty()) return SolveStatus::Solved;
    if (report_.iterations >= limit_) return SolveStatus::IterationLimit;
    if (kind_ == Step::Block) ++report_.iterations;
    const Index before = basis_.size();
    const std::vector<Index> closed = basis_.rows();
    const Index worst = candidates_.rows.front();
    SolveStatus status = SolveStatus::Solved;
    if (kind_ == Step::Single) {
      candidates_.rows.resize(1);
      status = press(worst);
    } else {
      rows_.fetch(basis_, gap_, rounding_, candidates_);
      if (basis_.append(candidates_, ActiveSetFactor::Choice::Violated, group_) > 0)
        settle(before);
      else
        status = exchange(worst);
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

/// Solves with the rows that joined at position `before` and behind, and drops until no force pulls.
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

void DualActiveSet::pass_over() { mark_stalled({pressed_}); }

/// Marks those that are open.
void DualActiveSet::mark_stalled(const std::vector<Index>& rows) {
  for (const Index row : rows)
    if (state_[at(row)] == Row::Open) {
      state_[at(row)] = Row::Stalled;
      any_stalled_ = true;
    }
}

void DualActiveSet::forget_stalled() {
  if (any_stalled_) std::replace(state_.begin(), state_.end(), Row::Stalled, Row::Open);
  any_stalled_ = false;
}

}  // namespace signorini

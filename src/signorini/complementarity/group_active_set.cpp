#include "signorini/complementarity/group_active_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Candidates = ClosedBasis::Candidates;

const double epsilon = std::numeric_limits<double>::epsilon();

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// Whether one energy is larger than another beyond rounding.
bool rises(double now, double before, Index size) {
  return now > before * (1 + static_cast<double>(size + 1) * epsilon);
}

}  // namespace

GroupActiveSet::GroupActiveSet(const GapRows& rows, ClosedBasis basis, Report& report, Index limit)
    : rows_(rows),
      basis_(std::move(basis)),
      saved_(basis_),
      report_(report),
      limit_(limit),
      group_(std::max<Index>(1, rows.rank / 4)),
      closed_(at(rows.count), 0),
      fruitless_(at(rows.count), 0) {}

void GroupActiveSet::solve() {
  basis_.solve(target_);
  ++report_.factorisations;
}

/// Positions of the basis whose force is not positive.
std::vector<Index> GroupActiveSet::pulling(const VectorXd& force) const {
  std::vector<Index> positions;
  for (Index k = 0; k < force.size(); ++k)
    if (force(k) <= 0 && basis_.rows()[at(k)] >= rows_.equations) positions.push_back(k);
  return positions;
}

void GroupActiveSet::drop(const std::vector<Index>& positions) {
  for (const Index k : positions) closed_[at(basis_.rows()[at(k)])] = 0;
  basis_.remove(positions);
}

Status GroupActiveSet::close_equations() {
  std::vector<Index> all(at(rows_.equations));
  std::iota(all.begin(), all.end(), Index{0});
  rows_.gaps(basis_, gap_, rounding_);
  Candidates candidates = rows_.fetch(all, basis_, gap_, rounding_);
  basis_.append(candidates, ClosedBasis::Choice::All, rows_.equations);
  for (const Index row : all) closed_[at(row)] = 1;
  solve();
  force_ = target_;
  for (Index i = 0; i < rows_.equations; ++i) {
    if (std::abs(candidates.gap(i)) <= 4 * candidates.rounding(i)) continue;
    // Row i depends on those that joined, and its own right side contradicts theirs.
    const Candidates one = rows_.fetch({i}, basis_, gap_, rounding_);
    const VectorXd response = basis_.response(one);
    const double sign = candidates.gap(i) < 0 ? 1 : -1;
    proof_.setZero(rows_.count);
    for (Index k = 0; k < response.size(); ++k) proof_(basis_.rows()[at(k)]) = -sign * response(k);
    proof_(i) = sign;
    return Status::Infeasible;
  }
  return Status::Solved;
}

/// Violated rows, the worst first, at most twice as many as may join.
std::vector<Index> GroupActiveSet::most_violated() {
  std::vector<Index> violated;
  double overlap = 0;
  for (Index i = rows_.equations; i < rows_.count; ++i) {
    if (closed_[at(i)] != 0 || gap_(i) >= -rounding_(i)) continue;
    overlap = std::max(overlap, -gap_(i));
    if (fruitless_[at(i)] == 0) violated.push_back(i);
  }
  report_.history.push_back(
      {basis_.size(), static_cast<Index>(violated.size()), overlap, 0, basis_.dual_energy()});
  const auto worse = [&](Index a, Index b) {
    const double first = gap_(a) * rows_.weight(a);
    const double second = gap_(b) * rows_.weight(b);
    return first < second || (first == second && a < b);
  };
  const std::size_t most = std::min(violated.size(), at(2 * group_));
  std::partial_sort(violated.begin(), violated.begin() + static_cast<std::ptrdiff_t>(most),
                    violated.end(), worse);
  violated.resize(most);
  return violated;
}

Status GroupActiveSet::run() {
  while (true) {
    rows_.gaps(basis_, gap_, rounding_);
    const std::vector<Index> violated = most_violated();
    if (violated.empty()) return Status::Solved;
    if (report_.iterations >= limit_) return Status::IterationLimit;
    ++report_.iterations;
    const Index before = basis_.size();
    const double energy = basis_.dual_energy();
    Candidates candidates = rows_.fetch(violated, basis_, gap_, rounding_);
    if (basis_.append(candidates, ClosedBasis::Choice::Violated, group_) > 0) {
      settle(before);
    } else {
      const Status status = exchange(violated.front());
      if (status != Status::Solved) return status;
    }
    if (rises(basis_.dual_energy(), energy, basis_.size())) {
      std::fill(fruitless_.begin(), fruitless_.end(), 0);
    } else {
      for (const Index row : violated) fruitless_[at(row)] = 1;
    }
  }
}

/// Solves with the rows that joined at position `before` and behind, and drops until no force pulls.
void GroupActiveSet::settle(Index before) {
  for (Index k = before; k < basis_.size(); ++k) closed_[at(basis_.rows()[at(k)])] = 1;
  solve();
  std::vector<Index> negative = pulling(target_);
  if (!negative.empty()) {
    saved_ = basis_;
    const double energy = 0.5 * basis_.coordinates().head(before).squaredNorm();
    while (!negative.empty()) {
      drop(negative);
      solve();
      negative = pulling(target_);
    }
    if (!rises(basis_.dual_energy(), energy, basis_.size())) {  // too bold: back, and step by step
      std::swap(basis_, saved_);
      for (const Index row : basis_.rows()) closed_[at(row)] = 1;
      force_.conservativeResize(basis_.size());
      force_.tail(basis_.size() - before).setZero();
      step_by_step();
      return;
    }
  }
  force_ = target_;
}

/// Moves from forces that do not pull towards the best for all closed rows; where a force vanishes
/// first, its row opens and the target changes. The dual energy rises all the way.
void GroupActiveSet::step_by_step() {
  while (true) {
    solve();
    double step = 1;
    for (const Index k : pulling(target_))
      step = std::min(step, force_(k) / (force_(k) - target_(k)));
    if (step == 1 && pulling(target_).empty()) break;
    std::vector<Index> vanished;
    for (const Index k : pulling(target_))
      if (force_(k) / (force_(k) - target_(k)) <= step) vanished.push_back(k);
    force_ += step * (target_ - force_);
    drop(vanished);
    for (auto k = vanished.rbegin(); k != vanished.rend(); ++k) {
      const Index behind = force_.size() - *k - 1;
      force_.segment(*k, behind) = force_.segment(*k + 1, behind).eval();
      force_.conservativeResize(force_.size() - 1);
    }
  }
  force_ = target_;
}

/// A violated row depends on the closed ones: presses it, while they yield, until the first one opens.
Status GroupActiveSet::exchange(Index row) {
  const VectorXd response = basis_.response(rows_.fetch({row}, basis_, gap_, rounding_));
  const double tiny = static_cast<double>(basis_.size() + 1) * std::sqrt(epsilon) * epsilon;
  double press = std::numeric_limits<double>::infinity();
  Index first = -1;
  for (Index k = 0; k < basis_.size(); ++k) {
    if (basis_.rows()[at(k)] < rows_.equations || response(k) <= tiny) continue;
    const double limit = force_(k) / response(k);
    if (limit < press) {
      press = limit;
      first = k;
    }
  }
  if (first < 0) {
    proof_.setZero(rows_.count);
    for (Index k = 0; k < basis_.size(); ++k) proof_(basis_.rows()[at(k)]) = -response(k);
    proof_(row) = 1;
    return Status::Infeasible;
  }
  force_ -= press * response;
  const Index behind = force_.size() - first - 1;
  force_.segment(first, behind) = force_.segment(first + 1, behind).eval();
  force_(force_.size() - 1) = press;
  drop({first});
  rows_.gaps(basis_, gap_, rounding_);
  Candidates candidates = rows_.fetch({row}, basis_, gap_, rounding_);
  if (basis_.append(candidates, ClosedBasis::Choice::All, 1) == 0) return Status::Breakdown;
  closed_[at(row)] = 1;
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
    positions = pulling(target_);
  } while (!positions.empty());
  force_ = target_;
  std::fill(fruitless_.begin(), fruitless_.end(), 0);
}

}  // namespace signorini

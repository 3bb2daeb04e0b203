#include "signorini/problem/active_set_factor.hpp"

#include <algorithm>
#include <cmath>

#include "signorini/core/dense.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/triangular.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

}  // namespace

ActiveSetFactor::ActiveSetFactor(Index space, Index capacity)
    : L_(capacity, capacity), Q_(space, space > 0 ? capacity : 0), y_(capacity) {
  rows_.reserve(static_cast<std::size_t>(capacity));
}

double ActiveSetFactor::smallest_distance() const {
  if (Q_.rows() > 0) return static_cast<double>(capacity() + Q_.rows() + 1) * epsilon;
  return std::pow(epsilon, 0.4);
}

/// Leaves in `cross_` what the candidates share with the basis, in `columns` or `block` the rest of
/// them, and in `pivot_` the squared length of that rest.
void ActiveSetFactor::project(Candidates& candidates) {
  const Index count = static_cast<Index>(candidates.rows.size());
  const Index k = size();
  if (cross_.cols() < count || cross_.rows() < capacity()) cross_.resize(capacity(), count);
  if (pivot_.size() < count) pivot_.resize(count);
  if (Q_.rows() > 0) {
    auto columns = candidates.columns.leftCols(count);
    if (k > 0) {
      const auto Q = Q_.leftCols(k);
      auto cross = cross_.topLeftCorner(k, count);
      cross.noalias() = Q.transpose() * columns;
      columns.noalias() -= Q * cross;
      if (again_.cols() < count || again_.rows() < capacity()) again_.resize(capacity(), count);
      auto again = again_.topLeftCorner(k, count);  // what rounding left behind
      again.noalias() = Q.transpose() * columns;
      columns.noalias() -= Q * again;
      cross += again;
    }
    for (Index i = 0; i < count; ++i) pivot_(i) = columns.col(i).squaredNorm();
  } else {
    auto cross = cross_.topLeftCorner(k, count);
    cross = candidates.cross;
    solve_lower_columns(L_.topLeftCorner(k, k), cross);
    candidates.block.noalias() -= cross.transpose() * cross;
    pivot_.head(count) = candidates.block.diagonal();
  }
}

/// Appends candidate `which` and projects the others off it; `first` pairs were there before its batch.
void ActiveSetFactor::push(Candidates& candidates, Index which, Index first) {
  const Index k = size();
  const Index count = static_cast<Index>(candidates.rows.size());
  const double root = std::sqrt(pivot_(which));
  L_.row(k).head(k) = cross_.col(which).head(k).transpose();
  L_(k, k) = root;
  y_(k) = -candidates.gap(which) / root;
  rows_.push_back(candidates.rows[static_cast<std::size_t>(which)]);
  pivot_(which) = -1;  // has joined
  if (Q_.rows() > 0) {
    Q_.col(k) = candidates.columns.col(which) / root;
  } else {  // `block` stays as it was projected; what the batch has in common is in `cross_`
    if (shared_.size() < count) shared_.resize(count);
    shared_.head(count) = candidates.block.col(which);
    shared_.head(count).noalias() -= cross_.block(first, 0, k - first, count).transpose() *
                                     cross_.col(which).segment(first, k - first);
    shared_.head(count) /= root;
  }
  for (Index i = 0; i < count; ++i) {
    if (pivot_(i) < 0) continue;
    if (Q_.rows() > 0) {
      cross_(k, i) = Q_.col(k).dot(candidates.columns.col(i));
      candidates.columns.col(i) -= cross_(k, i) * Q_.col(k);
      pivot_(i) = candidates.columns.col(i).squaredNorm();
    } else {
      cross_(k, i) = shared_(i);
      pivot_(i) = std::max(0.0, pivot_(i) - shared_(i) * shared_(i));
    }
    candidates.gap(i) += cross_(k, i) * y_(k);
  }
  candidates.gap(which) = 0;
}

/// What rounding may have made of the pivot of a row if only products are known: it is
/// (r, -1) G (r, -1)^T with r = L^-T L^-1 G_Wp, a sum of terms of at most this size. Three fifths of the
/// digits are trusted in any case.
double ActiveSetFactor::pivot_rounding(const VectorXd& yield) const {
  if (Q_.rows() > 0) return 0;
  return std::min(std::pow(epsilon, 0.6), epsilon * std::pow(1 + yield.lpNorm<1>(), 2));
}

Index ActiveSetFactor::append(Candidates& candidates, Choice choice, Index limit) {
  const Index count = static_cast<Index>(candidates.rows.size());
  const Index first = size();
  limit = std::min({limit, count, capacity() - first});
  if (limit <= 0) return 0;
  project(candidates);
  while (size() - first < limit) {
    const double smallest = smallest_distance() * smallest_distance();
    Index best = -1;
    double most = 0;
    for (Index i = 0; i < count; ++i) {
      if (pivot_(i) <= smallest) continue;
      if (choice == Choice::All) {
        best = i;
        break;
      }
      const double gap = candidates.gap(i);
      if (gap >= -candidates.rounding(i) || gap * gap <= most * pivot_(i)) continue;
      most = gap * gap / pivot_(i);
      best = i;
    }
    if (best < 0) break;
    if (Q_.rows() == 0) {
      VectorXd yield = cross_.col(best).head(size());
      solve_lower_transposed(L_, yield);
      if (pivot_(best) <= pivot_rounding(yield)) {
        pivot_(best) = 0;
        continue;
      }
    }
    push(candidates, best, first);
  }
  return size() - first;
}

void ActiveSetFactor::solve(Eigen::VectorXd& force) const {
  if (force.size() < capacity()) force.resize(capacity());
  force.head(size()) = y_.head(size());
  solve_lower_transposed(L_, force.head(size()));
}

}  // namespace signorini

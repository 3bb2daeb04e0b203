// # A factor that grows
//
// Methods that close pairs one by one solve with \f$ G_{WW} \f$ for a set W that hardly changes. To
// factor it each time would take \f$ m^3/3 \f$ operations. To append one row to a Cholesky factor L
// with \f$ LL^T = G_{WW} \f$ takes \f$ m^2 \f$. With \f$ y = -L^{-1}d_W \f$ the forces are
// \f$ L^{-T}y \f$, and y only gets one more entry.
//
// Two pairs with
// \f[ G = \begin{pmatrix} 1 & 0.5 \\ 0.5 & 1 \end{pmatrix}, \quad
// d = \begin{pmatrix} -1 \\ -1 \end{pmatrix}: \qquad
// L = \begin{pmatrix} 1 & 0 \\ 0.5 & 0.866 \end{pmatrix}, \quad
// y = \begin{pmatrix} 1 \\ 0.577 \end{pmatrix}. \f]
// The first pair brings the energy \f$ y_1^2/2 = 1/2 \f$. Behind it the second one overlaps by 0.5,
// and its *pivot*, how far the unit of its force opens it, is 1 - 0.25. It brings
// \f$ 0.5^2/(2 \cdot 0.75) = 1/6 \f$. Both forces are 2/3.
//
// A pivot that is rounding belongs to a pair that follows from the others. It must not join,
// because the factor would divide by it. How small is that? The pivot is the square of the distance
// of a row from those that have joined. If only G is known, a rounding of 1e-16 hides distances
// below 1e-8. If the columns of H with \f$ G = H^TH \f$ are known, Gram-Schmidt orthogonalisation
// finds the distance itself, and nearly all digits count. So the class keeps an orthonormal Q with
// \f$ H_W = QL^T \f$ where it can.

#include "signorini/problem/active_set_factor.hpp"

#include <algorithm>
#include <cmath>

#include "signorini/core/dense.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/triangular.hpp"

namespace signorini {

using Eigen::Index, Eigen::VectorXd;

ActiveSetFactor::ActiveSetFactor(Index space, Index capacity)
    : L_(capacity, capacity), Q_(space, space > 0 ? capacity : 0), y_(capacity) {
  rows_.reserve(static_cast<std::size_t>(capacity));
}

// Products know the square of a distance, so they trust fewer digits: 5.5e-7 in place of rounding.
double ActiveSetFactor::smallest_distance() const {
  if (Q_.rows() > 0) return static_cast<double>(capacity() + Q_.rows() + 1) * epsilon;
  return std::pow(epsilon, 0.4);
}

// The candidates are projected off the basis, all at once: products of matrices are fast. With
// columns this is done twice. What the first projection leaves behind by rounding may be as large
// as the rest of a nearly dependent column, and the second one removes it ("twice is enough").
//
// `cross_` holds what the candidates share with the basis, and `pivot_` the squared length of the
// rest.
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

// One candidate becomes the next row of L. The others are then projected off it, and their gaps
// change as if it were closed. With products alone, `block` stays as it was, and what the batch has
// in common is subtracted when a candidate joins: only then its column is needed.
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

// What rounding may have made of a pivot if only products are known. The pivot is
// \f$ (r, -1)\,G\,(r, -1)^T \f$ with \f$ r = G_{WW}^{-1}G_{Wp} \f$, a sum of terms of up to
// \f$ (1 + |r|_1)^2 \f$. If r is large, so is the rounding. Three fifths of the digits are trusted
// in any case.
double ActiveSetFactor::pivot_rounding(const VectorXd& yield) const {
  if (Q_.rows() > 0) return 0;
  return std::min(std::pow(epsilon, 0.6), epsilon * std::pow(1 + yield.lpNorm<1>(), 2));
}

// Of pairs that overlap, the one with the largest gain \f$ g^2/\text{pivot} \f$ of dual energy
// joins first. The gaps of the others are then new, because one closed pair may lift its
// neighbours. In the example both pairs gain 1 at first, and behind one of them the other gains
// 1/3: it still overlaps, so it joins too. With columns the pivot is trusted as it is. With
// products it is compared with its rounding, but only of the pair that is about to join, because
// that costs a triangular solve.
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

// One triangular solve: y is kept up to date.
void ActiveSetFactor::solve(Eigen::VectorXd& force) const {
  if (force.size() < capacity()) force.resize(capacity());
  force.head(size()) = y_.head(size());
  solve_lower_transposed(L_, force.head(size()));
}

}  // namespace signorini

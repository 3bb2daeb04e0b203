// # A factor that shrinks
//
// A pair that would pull has to leave the set. Its row of L goes, and what remains is triangular
// but for one entry too many in each row below. A *Givens rotation* of two neighbouring columns
// takes one such entry away. Rotations do not change \f$ LL^T \f$, so the result is the factor of
// the smaller set. This takes some \f$ m^2 \f$ operations, a new factor \f$ m^3/3 \f$. No rounding
// grows, because rotations keep lengths.
//
// From the two pairs of [active_set_factor.cpp](active_set_factor.cpp) the first one leaves. The
// row (0.5, 0.866) remains, and the rotation with c = 0.5, s = 0.866 makes (1, 0) of it. It makes
// \f$ 0.5 \cdot 1 + 0.866 \cdot 0.577 = 1 \f$ of y, and the second pair alone has the force 1.
// A factor made anew of that pair is the same.

#include <Eigen/Jacobi>
#include <algorithm>
#include <vector>

#include "signorini/core/triangular.hpp"
#include "signorini/problem/active_set_factor.hpp"

namespace signorini {

using Eigen::Index, Eigen::VectorXd;

// Dual methods ask two things before they close a pair: by how much the other forces fall, and how
// far its gap opens, per unit of its force. In the example it is 0.5 and 0.75. If the gap does not
// open at all, the pair depends on the others: some of their forces have to go before it can close,
// or nothing solves the problem.
ActiveSetFactor::Response ActiveSetFactor::response(const Candidates& candidates) const {
  const auto L = L_.topLeftCorner(size(), size()).triangularView<Eigen::Lower>();
  Response answer;
  VectorXd& r = answer.yield;
  if (Q_.rows() > 0) {
    VectorXd rest = candidates.columns.col(0);
    r.noalias() = directions().transpose() * rest;
    rest -= directions() * r;
    rest -= directions() * VectorXd(directions().transpose() * rest);  // what rounding left behind
    answer.opening = rest.squaredNorm();
  } else {
    r = candidates.cross.col(0);
    L.solveInPlace(r);
    answer.opening = candidates.block(0, 0) - r.squaredNorm();
  }
  L.transpose().solveInPlace(r);
  const double smallest = smallest_distance();
  if (answer.opening <= std::max(smallest * smallest, pivot_rounding(r))) answer.opening = 0;
  return answer;
}

// The diagonal of \f$ G_{WW}^{-1} \f$ tells how well each pair is determined. Here both entries are
// 4/3, and the distance of one row from the other is \f$ \sqrt{3/4} \f$.
double ActiveSetFactor::distance_from_others(Index position) const {
  // One over the root of the diagonal entry of (L L^T)^-1.
  VectorXd e = VectorXd::Unit(size(), position);
  solve_lower(L_, e);
  return 1 / e.norm();
}

// The rows below move up by one, and each then has one entry above the diagonal.
void ActiveSetFactor::remove_one(Index position) {
  const Index last = size() - 1;
  for (Index i = position; i < last; ++i) L_.row(i).head(i + 2) = L_.row(i + 1).head(i + 2);
  for (Index j = position; j < last; ++j) {
    // Row j now ends in columns j and j + 1: turn these so that the second entry vanishes.
    Eigen::JacobiRotation<double> turn;
    turn.makeGivens(L_(j, j), L_(j, j + 1));
    L_.middleRows(j, last - j).applyOnTheRight(j, j + 1, turn);
    y_.applyOnTheLeft(j, j + 1, turn.adjoint());
    // The columns of H are \f$ QL^T \f$, if they are kept.
    if (Q_.rows() > 0) Q_.applyOnTheRight(j, j + 1, turn);
  }
  rows_.erase(rows_.begin() + position);
}

// From behind, so that the positions in front stay right.
void ActiveSetFactor::remove(const std::vector<Index>& positions) {
  for (auto position = positions.rbegin(); position != positions.rend(); ++position)
    remove_one(*position);
}

// A method that stops halfway, at the first pair that would pull, has forces that are not those of
// the set. Their coordinates follow from them.
void ActiveSetFactor::set_force(const Eigen::VectorXd& force) {
  y_.head(size()) = L_.topLeftCorner(size(), size()).triangularView<Eigen::Lower>().transpose() *
                    force.head(size());
}

}  // namespace signorini

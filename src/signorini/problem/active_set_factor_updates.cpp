#include <algorithm>
#include <cmath>
#include <vector>

#include "signorini/core/triangular.hpp"
#include "signorini/problem/active_set_factor.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

}  // namespace

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

double ActiveSetFactor::distance_from_others(Index position) const {
  // One over the root of the diagonal entry of (L L^T)^-1.
  VectorXd e = VectorXd::Unit(size(), position);
  solve_lower(L_, e);
  return 1 / e.norm();
}

/// Row `position` of L goes; rotations of the columns behind it make L triangular again.
void ActiveSetFactor::remove_one(Index position) {
  const Index last = size() - 1;
  for (Index i = position; i < last; ++i) L_.row(i).head(i + 2) = L_.row(i + 1).head(i + 2);
  for (Index j = position; j < last; ++j) {
    // Row j now ends in columns j and j + 1: turn these so that the second entry vanishes.
    const double a = L_(j, j);
    const double b = L_(j, j + 1);
    const double r = std::hypot(a, b);
    const double c = a / r;
    const double s = b / r;
    for (Index i = j; i < last; ++i) {
      const double first = L_(i, j);
      const double second = L_(i, j + 1);
      L_(i, j) = c * first + s * second;
      L_(i, j + 1) = c * second - s * first;
    }
    const double first = y_(j);
    y_(j) = c * first + s * y_(j + 1);
    y_(j + 1) = c * y_(j + 1) - s * first;
    double* q = Q_.data() + j * Q_.rows();
    double* p = q + Q_.rows();
    for (Index i = 0; i < Q_.rows(); ++i) {
      const double along = q[i];
      q[i] = c * along + s * p[i];
      p[i] = c * p[i] - s * along;
    }
  }
  rows_.erase(rows_.begin() + position);
}

void ActiveSetFactor::remove(const std::vector<Index>& positions) {
  for (auto position = positions.rbegin(); position != positions.rend(); ++position)
    remove_one(*position);
}

void ActiveSetFactor::set_force(const Eigen::VectorXd& force) {
  y_.head(size()) = L_.topLeftCorner(size(), size()).triangularView<Eigen::Lower>().transpose() *
                    force.head(size());
}

}  // namespace signorini

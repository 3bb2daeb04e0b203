#include "addons/many_bodies/sparse_set_system.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/sparse_lu.hpp"
#include "signorini/problem/exact_vector.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// A sweep leaves eps^(3/4) over an eigenvalue of what the one before left. Where six do not do, that is more than 1/400, and the
/// condition is beyond 1e9. Either forces are known to fewer than the six digits that are printed: then others have to say so. Or it
/// is a motion that hardly anything resists, as of a tall stack that leans: then sweeps go on.
constexpr int few_sweeps = 6;
/// It is a motion if the share of the positions that a sweep changes is so many times that of the forces.
constexpr double of_motion = 16;
/// Of the largest force: what a force may be wrong by behind the last sweep. The certificate lets pass 22 times as much.
constexpr double force_rounding = 200 * epsilon;

/// What columns are multiplied by, so that the diagonal of H, or else the longest entry of B, is about 1.
VectorXd column_scales(const SparseMatrix& H, const SparseMatrix& B) {
  VectorXd size = VectorXd(H.diagonal()).cwiseMax(0.0).cwiseSqrt();
  for (Index j = 0; j < B.cols(); ++j)
    if (size(j) == 0)
      for (SparseMatrix::InnerIterator it(B, j); it; ++it)
        size(j) = std::max(size(j), std::abs(it.value()));
  return powers_of_two((size.array() > 0).select(size.cwiseInverse(), 1.0));
}

}  // namespace

SparseSetSystem::SparseSetSystem(const SparseContact& problem)
    : row_scale_(powers_of_two(problem.scale)), B_(row_scale_.asDiagonal() * problem.rows) {
  column_scale_ = column_scales(problem.stiffness, B_);
  const auto columns = column_scale_.asDiagonal();
  B_ = SparseMatrix(B_ * columns);
  BT_ = B_.transpose();
  H_ = SparseMatrix(columns * problem.stiffness * columns);
  F_ = SparseMatrix(row_scale_.asDiagonal() * problem.compliance * row_scale_.asDiagonal());
  load_ = columns * problem.load;
  units_.free = row_scale_.cwiseProduct(problem.free);
  units_.law = problem.law;
  const Index pairs = units_.pairs();
  for (std::size_t k = 0; k < units_.law.pair.size(); ++k) {
    const Index slip = static_cast<Index>(k);
    const double own = row_scale_(pairs + slip);
    units_.law.coefficient(slip) *= row_scale_(units_.law.pair[k]) / own;
    units_.law.cohesion(slip) /= own;
  }
  x_.setZero(load_.size());
  low_.setZero(load_.size());
  now_.force.setZero(units_.free.size());
}

double SparseSetSystem::regularity() const {
  return alone() ? std::sqrt(epsilon) : std::pow(epsilon, 0.75);
}

SparseMatrix SparseSetSystem::matrix(const ActiveSet& set, double soft) const {
  const Index n = x_.size();
  const Index m = static_cast<Index>(set.closed.size());
  const double regular = regularity();
  std::vector<Index> place(at(units_.free.size()), -1);
  for (Index i = 0; i < m; ++i) place[at(set.closed[at(i)])] = n + i;
  Triplets entries;
  for (Index j = 0; j < n; ++j) {
    entries.emplace_back(j, j, regular);
    for (SparseMatrix::InnerIterator it(H_, j); it; ++it)
      entries.emplace_back(it.row(), j, it.value());
  }
  // What a force in column `column` does, slope times that of row `row`.
  const auto acts = [&](Index row, Index column, double slope) {
    for (SparseMatrix::InnerIterator it(BT_, row); it; ++it)
      entries.emplace_back(it.row(), column, slope * it.value());
    for (SparseMatrix::InnerIterator it(F_, row); it; ++it)
      if (const Index there = place[at(it.row())]; there >= 0)
        entries.emplace_back(there, column, -slope * it.value());
  };
  for (Index i = 0; i < m; ++i) {
    const Index row = set.closed[at(i)];
    acts(row, n + i, 1);
    for (SparseMatrix::InnerIterator it(BT_, row); it; ++it)
      entries.emplace_back(n + i, it.row(), it.value());
    entries.emplace_back(n + i, n + i, -(soft + regular));
  }
  for (const SlidingPair& pair : set.sliding)
    if (pair.slope != 0) acts(pair.slip, place[at(pair.gap)], pair.slope);
  SparseMatrix M(n + m, n + m);
  M.setFromTriplets(entries.begin(), entries.end());
  return M;
}

VectorXd SparseSetSystem::imbalance() const {
  ExactVector sum(load_);
  for (Index j = 0; j < x_.size(); ++j) {
    sum.add_product(H_, j, -x_(j));
    sum.add_product(H_, j, -low_(j));
  }
  for (Index i = 0; i < now_.force.size(); ++i)
    if (now_.force(i) != 0) sum.add_product(BT_, i, -now_.force(i));
  return sum.value();
}

VectorXd SparseSetSystem::movement() const {
  ExactVector sum(units_.free);
  for (Index j = 0; j < x_.size(); ++j) {
    sum.add_product(B_, j, -x_(j));
    sum.add_product(B_, j, -low_(j));
  }
  for (Index i = 0; i < now_.force.size(); ++i)
    if (now_.force(i) != 0) sum.add_product(F_, i, now_.force(i));
  return sum.value();
}

bool SparseSetSystem::closes(const ActiveSet& set) {
  settle(set);
  // Rows that depend on each other contradict each other by what rounding did to any of them.
  return largest(VectorXd(movement()(set.closed))) <= largest(now_.movement_rounding);
}

bool SparseSetSystem::solve(const ActiveSet& set, double soft) {
  SparseLuFactor factor;
  if (!factor.factorise(matrix(set, soft))) return false;
  const Index n = x_.size();
  const Index m = static_cast<Index>(set.closed.size());
  VectorXd low = VectorXd::Zero(now_.force.size());  // of forces in one double
  impose(set, now_.force, low);
  double before = std::numeric_limits<double>::infinity();  // share of the positions that the last sweep changed
  for (int sweep = 1;; ++sweep) {
    VectorXd right(n + m);
    right.head(n) = imbalance();
    right.tail(m) = movement()(set.closed) + soft * now_.force(set.closed);
    const VectorXd change = factor.solve(right);
    if (!change.allFinite()) return false;
    for (Index j = 0; j < n; ++j) add_to(x_(j), low_(j), change(j));
    for (Index i = 0; i < m; ++i) now_.force(set.closed[at(i)]) += change(n + i);
    impose(set, now_.force, low);
    // The last digits of x are in its second part, so that one sweep more refines them as well.
    const double moved = ratio(largest(VectorXd(change.head(n))), largest(x_));
    const double pushed = ratio(largest(VectorXd(change.tail(m))), largest(now_.force));
    settled_ = alone() ? soft == 0 && closes(set) : std::max(moved, pushed) <= epsilon;
    const bool motion = !alone() && (pushed <= epsilon || of_motion * pushed <= moved) && 2 * moved <= before;
    if (settled_ || (sweep >= few_sweeps && !motion)) return true;
    before = moved;  // at least halved, so that sweeps end
  }
}

void SparseSetSystem::settle(const ActiveSet& set) {
  now_.movement = movement();
  const VectorXd terms = units_.free.cwiseAbs() + B_.cwiseAbs() * x_.cwiseAbs() +
                         F_.cwiseAbs() * now_.force.cwiseAbs();
  now_.movement_rounding = 8 * epsilon * terms;
  now_.force_rounding = force_rounding * largest(now_.force);
  now_.movement(set.closed).setZero();
}

void SparseSetSystem::take(ActiveSetSolution numbers) {
  now_ = std::move(numbers);
  now_.movement = movement();
  now_.movement_rounding.resize(0);
}

void SparseSetSystem::write(SparseContactSolution& found) const {
  found.position = column_scale_.cwiseProduct(x_);
  found.position_low = column_scale_.cwiseProduct(low_);
  found.force = row_scale_.cwiseProduct(now_.force);
  found.movement = now_.movement.cwiseQuotient(row_scale_);
}

}  // namespace signorini

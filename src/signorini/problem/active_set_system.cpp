#include "signorini/problem/active_set_system.hpp"

#include <algorithm>
#include <cmath>

#include "signorini/core/rounding.hpp"
#include "signorini/problem/exact_vector.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Rows = std::vector<Index>;
using Entry = Eigen::SparseMatrix<double>::InnerIterator;

/// Sweeps of refinement at most: they end by themselves when nothing changes, so more would cost time where none
/// helps. A factor of few entries had sqrt(epsilon) added to its diagonal, so that each sweep leaves sqrt(epsilon)
/// over an eigenvalue and more are needed. What comes out is confirmed on exact sums, so no answer depends on either.
constexpr int most_sweeps = 4;
constexpr int most_sparse_sweeps = 16;

bool has_slopes(const ActiveSet& set) {
  for (const SlidingPair& pair : set.sliding)
    if (pair.slope != 0) return true;
  return false;
}

/// Positions of the rows of a block that are independent of those before them, by a Cholesky factor that
/// grows row by row: a squared pivot of rounding size means that a row repeats others.
Rows independent_rows(const MatrixXd& block, double tiny) {
  MatrixXd L(block.rows(), block.rows());
  Rows chosen;
  for (Index i = 0; i < block.rows(); ++i) {
    const Index k = static_cast<Index>(chosen.size());
    VectorXd row = block(chosen, i);
    L.topLeftCorner(k, k).triangularView<Eigen::Lower>().solveInPlace(row);
    const double pivot = block(i, i) - row.squaredNorm();
    if (pivot <= tiny * block(i, i)) continue;
    L.row(k).head(k) = row.transpose();
    L(k, k) = std::sqrt(pivot);
    chosen.push_back(i);
  }
  return chosen;
}

/// Orthonormal columns that span what the rows of a matrix span, to rounding.
MatrixXd row_space(const MatrixXd& matrix) {
  if (matrix.size() == 0) return MatrixXd(matrix.cols(), 0);
  const SingularValues all = singular_values(matrix);
  const double threshold =
      static_cast<double>(matrix.rows() + matrix.cols()) * epsilon * all.values(0);
  return all.V.leftCols((all.values.array() > threshold).count());
}

/// Puts every friction force that is at its bound there.
void impose(const ActiveSet& set, VectorXd& force) {
  for (const SlidingPair& pair : set.sliding)
    force(pair.slip) = pair.friction(force(pair.gap)).value();
}

/// The numbers to start from: no force that the set excludes.
void begin(const ScaledProblem& problem, const Rows& support, const ActiveSetSolution* start,
           ActiveSetSolution& now) {
  now.force.setZero(problem.free.size());
  now.amplitude.setZero(problem.rigid.cols());
  if (start == nullptr) return;
  if (start->amplitude.size() == now.amplitude.size() && start->amplitude.allFinite())
    now.amplitude = start->amplitude;
  if (start->force.size() == now.force.size() && start->force.allFinite())
    for (const Index j : support) now.force(j) = start->force(j);
}

/// All movements of the forces, what rounding may have done to them, and whether the equations hold.
void settle(const ScaledProblem& problem, const Rows& support, ActiveSetSolution& now) {
  const Index modes = problem.rigid.cols();
  now.movement = problem.free;
  VectorXd size = problem.free.cwiseAbs();
  for (const Index j : support) {
    const double force = now.force(j);
    if (problem.sparse.size() == 0) {
      now.movement += force * problem.compliance.col(j);
      size += std::abs(force) * problem.compliance.col(j).cwiseAbs();
      continue;
    }
    for (Entry entry(problem.sparse, j); entry; ++entry) {
      now.movement(entry.row()) += force * entry.value();
      size(entry.row()) += std::abs(force * entry.value());
    }
  }
  for (Index j = 0; j < modes; ++j) {
    now.movement += now.amplitude(j) * problem.rigid.col(j);
    size += std::abs(now.amplitude(j)) * problem.rigid.col(j).cwiseAbs();
  }
  const double rounding = static_cast<double>(support.size() + modes + 1) * epsilon;
  now.force_rounding = rounding * largest(now.force);
  now.movement_rounding = rounding * size;
  now.solvable = now.force.allFinite() && now.movement.allFinite();
  for (const Index row : now.rows) {
    if (!now.closes(row)) now.solvable = false;
    now.movement(row) = 0;
  }
  for (Index j = 0; j < modes; ++j) {
    const double terms =  // a force far off the axis may be as wrong as the largest one
        std::abs(problem.resultant(j)) + largest(problem.rigid.col(j)) * now.force.lpNorm<1>();
    ExactVector left(VectorXd::Constant(1, -problem.resultant(j)));
    left.add_products(problem.rigid.col(j), now.force);
    if (std::abs(left.value()(0)) > 2 * rounding * terms) now.solvable = false;
  }
}

}  // namespace

ActiveSetSystem::ActiveSetSystem(const ScaledProblem& problem, const ActiveSet& set)
    : rows_(set.closed) {
  const bool sparse = problem.sparse.size() > 0;
  symmetric_ = problem.symmetric && !has_slopes(set) && !sparse;
  if (sparse)
    factor_sparse(problem, set);
  else if (symmetric_)
    factor_symmetric(problem);
  else
    factor_general(problem, set);
}

void ActiveSetSystem::factor_symmetric(const ScaledProblem& problem) {
  const Index modes = problem.rigid.cols();
  const double trace = problem.compliance.trace();
  rho_ = modes > 0 ? (trace > 0 ? trace : 1) : 0;
  MatrixXd block = problem.compliance(rows_, rows_);
  if (modes > 0) {
    rigid_ = problem.rigid(rows_, Eigen::all);
    block.noalias() += rho_ * rigid_ * rigid_.transpose();
  }
  const double tiny = 2 * static_cast<double>(rows_.size() + 1) * epsilon;
  if (!rows_.empty()) factor_ = CholeskyFactor(block);
  if (!rows_.empty() &&
      (!factor_.positive() ||
       (factor_.lower().diagonal().array().square() <= tiny * block.diagonal().array()).any())) {
    const Rows chosen = independent_rows(block, tiny);
    const MatrixXd kept = block(chosen, chosen);
    factor_ = chosen.empty() ? CholeskyFactor() : CholeskyFactor(kept);
    Rows rows;
    for (const Index i : chosen) rows.push_back(rows_[static_cast<std::size_t>(i)]);
    rows_ = std::move(rows);
    if (modes > 0) rigid_ = problem.rigid(rows_, Eigen::all);
  }
  if (modes == 0) return;
  held_ = row_space(rigid_);
  if (held_.cols() == 0) return;
  MatrixXd half = rigid_ * held_;
  solve_lower_columns(factor_.lower(), half);
  schur_ = CholeskyFactor(half.transpose() * half);
  spread_ = factor_.solve_columns(rigid_ * held_);
}

MatrixXd closing_matrix(const ScaledProblem& problem, const Rows& rows, const ActiveSet& set) {
  const Index m = static_cast<Index>(rows.size());
  const Index k = problem.rigid.cols();
  MatrixXd M = MatrixXd::Zero(m + k, m + k);
  M.topLeftCorner(m, m) = problem.compliance(rows, rows);
  if (k > 0) {
    M.topRightCorner(m, k) = problem.rigid(rows, Eigen::all);
    M.bottomLeftCorner(k, m) = M.topRightCorner(m, k).transpose();
  }
  for (const SlidingPair& pair : set.sliding) {
    const Index column = std::find(rows.begin(), rows.end(), pair.gap) - rows.begin();
    M.col(column).head(m) += pair.slope * problem.compliance(rows, pair.slip);
    if (k > 0) M.col(column).tail(k) += pair.slope * problem.rigid.row(pair.slip).transpose();
  }
  return M;
}

void ActiveSetSystem::factor_general(const ScaledProblem& problem, const ActiveSet& set) {
  const Index m = static_cast<Index>(rows_.size());
  const Index k = problem.rigid.cols();
  if (m + k == 0) return;
  const MatrixXd M = closing_matrix(problem, rows_, set);
  general_ = LuFactor(M);
  const bool regular = general_.rcond() > static_cast<double>(m + k + 1) * epsilon;
  if (!regular) inverse_ = pseudo_inverse(M);
  // The sign of a determinant, which itself may overflow.
  const bool odd = (general_.pivots().array() < 0).count() % 2 == 1;
  const bool negative = odd != (general_.permutation_sign() < 0);
  reversed_ = regular && negative != (k % 2 == 1);
}

void ActiveSetSystem::factor_sparse(const ScaledProblem& problem, const ActiveSet& set) {
  const Index m = static_cast<Index>(rows_.size());
  const Index k = problem.rigid.cols();
  if (m + k == 0) return;
  Rows place(static_cast<std::size_t>(problem.free.size()), -1);
  for (Index i = 0; i < m; ++i)
    place[static_cast<std::size_t>(rows_[static_cast<std::size_t>(i)])] = i;
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](Index row, Index column, double slope) {
    for (Entry entry(problem.sparse, row); entry; ++entry)
      if (const Index at = place[static_cast<std::size_t>(entry.row())]; at >= 0)
        entries.emplace_back(at, column, slope * entry.value());
    for (Index j = 0; j < k; ++j)
      entries.emplace_back(m + j, column, slope * problem.rigid(row, j));
  };
  for (Index i = 0; i < m; ++i) {
    const Index row = rows_[static_cast<std::size_t>(i)];
    add(row, i, 1);
    for (Index j = 0; j < k; ++j) entries.emplace_back(i, m + j, problem.rigid(row, j));
  }
  for (const SlidingPair& pair : set.sliding)
    add(pair.slip, place[static_cast<std::size_t>(pair.gap)], pair.slope);
  for (Index i = 0; i < m + k; ++i)
    entries.emplace_back(i, i, (i < m ? 1 : -1) * std::sqrt(epsilon));
  Eigen::SparseMatrix<double> M(m + k, m + k);
  M.setFromTriplets(entries.begin(), entries.end());
  sparse_ = std::make_unique<SparseLuFactor>();
  const bool regular = sparse_->factorise(M);
  reversed_ = regular && (sparse_->sign() < 0) != (k % 2 == 1);
  if (regular) return;
  sparse_ = nullptr;
  factor_general(problem, set);
}

std::pair<VectorXd, VectorXd> ActiveSetSystem::solve(const VectorXd& top,
                                                     const VectorXd& bottom) const {
  const Index m = top.size();
  if (!symmetric_) {
    if (m + bottom.size() == 0) return {top, bottom};
    VectorXd right(m + bottom.size());
    right << top, bottom;
    const VectorXd both = sparse_               ? sparse_->solve(right)
                          : inverse_.size() > 0 ? VectorXd(inverse_ * right)
                                                : general_.solve(right);
    return {both.head(m), both.tail(bottom.size())};
  }
  VectorXd amplitude = VectorXd::Zero(bottom.size());
  if (m == 0) return {top, amplitude};
  if (bottom.size() == 0) return {factor_.solve(top), amplitude};
  VectorXd load = top + rho_ * (rigid_ * bottom);
  if (held_.cols() > 0)
    amplitude = held_ * schur_.solve(spread_.transpose() * load - held_.transpose() * bottom);
  load -= rigid_ * amplitude;
  return {factor_.solve(load), amplitude};
}

namespace {

/// How far forces move the rows of a system, summed exactly.
class RowMovement {
 public:
  RowMovement(const ScaledProblem& problem, const Rows& rows, const Rows& support)
      : problem_(problem), rows_(rows), support_(support) {
    if (!sparse_) columns_ = problem.compliance(rows, support);
    if (!sparse_ && problem.rigid.cols() > 0) rigid_ = problem.rigid(rows, Eigen::all);
  }
  [[nodiscard]] VectorXd of(const ActiveSetSolution& now) const {
    ExactVector sum(sparse_ ? problem_.free : VectorXd(problem_.free(rows_)));
    for (std::size_t c = 0; c < support_.size(); ++c) {
      const double force = now.force(support_[c]);
      if (sparse_ && force != 0) sum.add_product(problem_.sparse, support_[c], force);
      if (!sparse_ && force != 0) sum.add_product(columns_.col(static_cast<Index>(c)), force);
    }
    for (Index j = 0; j < problem_.rigid.cols(); ++j)
      sum.add_product(sparse_ ? problem_.rigid.col(j) : rigid_.col(j), now.amplitude(j));
    return sparse_ ? VectorXd(sum.value()(rows_)) : sum.value();
  }

 private:
  const ScaledProblem& problem_;
  const Rows& rows_;
  const Rows& support_;
  bool sparse_ = problem_.sparse.size() > 0;
  MatrixXd columns_, rigid_;
};

}  // namespace

ActiveSetSolution solve_active_set(const ScaledProblem& problem, const ActiveSet& set,
                                   const ActiveSetSolution* start) {
  const ActiveSetSystem system(problem, set);
  const Rows& rows = system.rows();
  Rows support = set.closed;
  for (const SlidingPair& pair : set.sliding) support.push_back(pair.slip);
  ActiveSetSolution now;
  now.rows = rows;
  std::sort(now.rows.begin(), now.rows.end());
  now.reversed = system.reversed();
  begin(problem, support, start, now);
  impose(set, now.force);
  const Index modes = problem.rigid.cols();
  const bool sparse = problem.sparse.size() > 0;
  const RowMovement moved(problem, rows, support);
  const int most = sparse ? most_sparse_sweeps : most_sweeps;
  for (int step = 0; step < most && !(rows.empty() && modes == 0); ++step) {
    ExactVector balance(modes > 0 ? VectorXd(-problem.resultant) : VectorXd());
    if (modes > 0) balance.add_products(problem.rigid, now.force);
    const auto [change, turn] = system.solve(-moved.of(now), -balance.value());
    for (std::size_t r = 0; r < rows.size(); ++r)
      now.force(rows[r]) += change(static_cast<Index>(r));
    now.amplitude += turn;
    impose(set, now.force);
    // The first sweep solves, two refine: forces much smaller than the largest need the second as well.
    if (step >= 2 && largest(change) <= 0.25 * epsilon * largest(now.force) &&
        largest(turn) <= 0.25 * epsilon * largest(now.amplitude))
      break;
  }
  settle(problem, support, now);
  return now;
}

ActiveSetSolution solve_active_set(const ScaledProblem& problem,
                                   const std::vector<ContactStatus>& statuses,
                                   const ActiveSetSolution* start) {
  return solve_active_set(problem, active_set(statuses, problem.law), start);
}

}  // namespace signorini

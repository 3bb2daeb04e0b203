// # The forces of a known set
//
// Every method of this library ends here: what all pairs do is known, and the forces follow from linear
// equations. Closed rows do not move, friction forces of sliding pairs are at their bounds, all other forces
// are 0, and forces balance the load along rigid modes.
//
// The matrix is factored by one of three functions: symmetric_system(), general_system() and sparse_system().
// A factor in doubles loses as many digits as the condition number has. So the residual is summed exactly,
// the factor gives a correction, and again: iterative refinement, as for any linear system. With the
// compliance (1 1; 1 1 + 1e-10) and free gaps (-1, -1) the first solve has about six right digits, and the
// second has all of them.
//
// These are digits of the condensed problem, whose numbers are rounded themselves. They are enough to tell signs by,
// and a method asks for many sets, so sweeps must be cheap. For the last set alone iterative_refinement() does the
// same with K, p, A and g as they were posed.
//
// The result says how far it can be trusted: what rounding may have done to each force and movement. Signs are
// read with these bounds, by predict().

#include "signorini/problem/active_set_system.hpp"

#include <algorithm>

#include "signorini/core/rounding.hpp"
#include "signorini/problem/exact_vector.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using Rows = std::vector<Index>;
using Entry = Eigen::SparseMatrix<double>::InnerIterator;

// Sweeps of refinement at most: they end by themselves when nothing changes, so more would cost time where none
// helps. A factor of few entries had sqrt(epsilon) added to its diagonal, so that each sweep leaves sqrt(epsilon)
// over an eigenvalue and more are needed. What comes out is confirmed on exact sums, so no answer depends on either.
constexpr int most_sweeps = 4;
constexpr int most_sparse_sweeps = 16;

// Whether a friction force follows its normal force: then the matrix is not symmetric. A pair with cohesion and
// mu = 0 slides against a given force, which is a load and no part of the matrix.
bool has_slopes(const ActiveSet& set) {
  for (const SlidingPair& pair : set.sliding)
    if (pair.slope != 0) return true;
  return false;
}

// The numbers to start from: no force that the set excludes. Where a system has several solutions, as with
// dependent rows, this choice decides which one is found: the one nearest to where the method stands.
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

// All movements of the forces, what rounding may have done to them, and whether the equations hold.
//
// A movement is the sum of a free movement and of one term per force and mode. Each addition rounds its result,
// so a sum of n terms is wrong by at most n times epsilon times the sum of the sizes of its terms. With three
// forces, terms of size 1 and a movement of 1e-16 nothing says whether that pair is open: its bound is
// \f$ 4 \cdot 2.2\cdot 10^{-16} \cdot 3 = 2.7\cdot 10^{-15} \f$. The bound of a force is that of the largest one, because
// the factor mixes all of them.
//
// Closed rows have movement 0 by what was assumed. If they have moved by more than the bounds, no forces close
// them: rows that repeat each other ask for different gaps. The set is then called unsolvable, and its numbers
// are the nearest that there are.
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
  // Closed rows have moved by rounding, or the system was singular to rounding. Then they count as 0.
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

// How far forces move the rows of a system, which should not move at all: the residual of a sweep. What is left
// near the end is much smaller than its terms. A plain sum would leave its own rounding, so the products are
// summed exactly. Columns are copied once, because the sweeps use the
// same ones.
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

// Rows that repeat others are kept or left by their order. Without any, an order is as good as another.
bool is_of(const ActiveSetSystem& system, ActiveSet set) {
  Rows given = system.set.closed;
  if (system.rows.size() == given.size()) {
    std::sort(given.begin(), given.end());
    std::sort(set.closed.begin(), set.closed.end());
  }
  return given == set.closed && system.set.sliding == set.sliding;
}

}  // namespace

// A method, its proofs and the refinement after it ask for the same set in turn, and it is factored once.
//
// Which of the three factors it is. Friction without a slope, as Tresca's, leaves the matrix symmetric, and one
// Cholesky factor does. Where F has few entries a sparse factor is faster than either dense one, with sliding
// or without.
ActiveSetSystem active_set_system(const ScaledProblem& problem, const ActiveSet& set) {
  if (problem.factored && is_of(*problem.factored, set)) return *problem.factored;
  ActiveSetSystem system = problem.sparse.size() > 0 ? sparse_system(problem, set)
                           : problem.symmetric && !has_slopes(set)
                               ? symmetric_system(problem, set.closed)
                               : general_system(problem, set);
  system.set = set;
  return system;
}

// The first sweep solves, the next ones refine: each asks the system for the changes that close what the rows
// still move, and that balance what the forces still lack. Friction is imposed after each, so that it follows
// the normal forces exactly.
ActiveSetSolution solve_active_set(const ScaledProblem& problem, const ActiveSet& set,
                                   const ActiveSetSolution* start) {
  ActiveSetSolution now;
  now.system = std::make_shared<const ActiveSetSystem>(active_set_system(problem, set));
  const ActiveSetSystem& system = *now.system;
  const Rows& rows = system.rows;
  Rows support = set.closed;
  for (const SlidingPair& pair : set.sliding) support.push_back(pair.slip);
  now.rows = rows;
  std::sort(now.rows.begin(), now.rows.end());
  now.reversed = system.reversed;
  begin(problem, support, start, now);
  VectorXd low = VectorXd::Zero(now.force.size());  // of forces in one double
  impose(set, now.force, low);
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
    impose(set, now.force, low);
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

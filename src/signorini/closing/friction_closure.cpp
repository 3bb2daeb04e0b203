#include "signorini/closing/friction_closure.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "signorini/core/dense.hpp"
#include "signorini/core/exact_vector.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Which rows and columns of F the motions leave in the system.
struct Rows {
  std::vector<Index> free;      ///< pairs that are closed, then n + pairs that stick
  std::vector<Index> contacts;  ///< pairs that are closed
};

Rows rows_of(const std::vector<Motion>& motions) {
  Rows rows;
  const Index n = static_cast<Index>(motions.size());
  for (Index i = 0; i < n; ++i)
    if (motions[static_cast<std::size_t>(i)] != Motion::Open) rows.contacts.push_back(i);
  rows.free = rows.contacts;
  for (const Index i : rows.contacts)
    if (motions[static_cast<std::size_t>(i)] == Motion::Stick) rows.free.push_back(n + i);
  return rows;
}

/// tau = -b or b where pairs slide, and no force at all where they are open.
void impose(const ScaledFriction& problem, const std::vector<Motion>& motions, VectorXd& force) {
  const Index n = problem.coefficient.size();
  for (Index i = 0; i < n; ++i) {
    const Motion motion = motions[static_cast<std::size_t>(i)];
    if (motion == Motion::Open) force(i) = force(n + i) = 0;
    if (friction_sign(motion) != 0)
      force(n + i) = friction_sign(motion) *
                     (problem.coefficient(i) * force(i) + problem.cohesion(i));  // LinEtAl 15, 16
  }
}

/// The matrix of the system, and below it R^T.
MatrixXd system_of(const ScaledFriction& problem, const std::vector<Motion>& motions,
                   const Rows& rows) {
  const Index n = problem.coefficient.size();
  const Index m = static_cast<Index>(rows.free.size());
  const Index k = problem.resultant.size();
  MatrixXd A = MatrixXd::Zero(m + k, m + k);
  A.topLeftCorner(m, m) = problem.compliance(rows.free, rows.free);
  A.topRightCorner(m, k) = problem.rigid(rows.free, Eigen::all);
  A.bottomLeftCorner(k, m) = A.topRightCorner(m, k).transpose();
  for (std::size_t c = 0; c < rows.contacts.size(); ++c) {
    const Index i = rows.contacts[c];
    const double slope = friction_sign(motions[static_cast<std::size_t>(i)]) *
                         problem.coefficient(i);  // d tau / d lambda
    if (slope == 0) continue;
    A.col(static_cast<Index>(c)).head(m) += slope * problem.compliance(rows.free, n + i);
    A.col(static_cast<Index>(c)).tail(k) += slope * problem.rigid.row(n + i).transpose();
  }
  return A;
}

/// free + F f + R a, summed in twice the working precision.
VectorXd movement_of(const ScaledFriction& problem, const FrictionClosure& closure) {
  ExactVector sum(problem.free);
  for (Index j = 0; j < closure.force.size(); ++j)
    if (closure.force(j) != 0) sum.add_product(problem.compliance.col(j), closure.force(j));
  for (Index j = 0; j < closure.amplitude.size(); ++j)
    sum.add_product(problem.rigid.col(j), closure.amplitude(j));
  return sum.value();
}

/// What is left of the equations: minus the movements that must vanish, and r - R^T f.
VectorXd residual(const ScaledFriction& problem, const Rows& rows, FrictionClosure& closure) {
  closure.movement = movement_of(problem, closure);
  ExactVector balance(-problem.resultant);
  balance.add_products(problem.rigid, closure.force);
  VectorXd left(static_cast<Index>(rows.free.size()) + problem.resultant.size());
  left << -closure.movement(rows.free), -balance.value();
  return left;
}

/// Adds a correction to the unknowns of the system.
void correct(const ScaledFriction& problem, const std::vector<Motion>& motions, const Rows& rows,
             const VectorXd& change, FrictionClosure& closure) {
  for (std::size_t c = 0; c < rows.free.size(); ++c)
    closure.force(rows.free[c]) += change(static_cast<Index>(c));
  closure.amplitude += change.tail(closure.amplitude.size());
  impose(problem, motions, closure.force);
}

/// The sign of a determinant, which itself may overflow.
bool negative(const LuFactor& factor) {
  const auto below = (factor.pivots().array() < 0).count();
  return (below % 2 == 1) != (factor.permutation_sign() < 0);
}

/// Rounding of each movement: what its terms are worth.
VectorXd rounding_of(const ScaledFriction& problem, const FrictionClosure& closure) {
  VectorXd size = problem.free.cwiseAbs();
  size.noalias() += problem.compliance.cwiseAbs() * closure.force.cwiseAbs();
  size.noalias() += problem.rigid.cwiseAbs() * closure.amplitude.cwiseAbs();
  return static_cast<double>(closure.force.size() + 2) * epsilon * size;
}

/// Looks at every sign, sets to zero what is zero, and asks the certificate.
bool confirm(const ScaledFriction& problem, const std::vector<Motion>& motions, const Rows& rows,
             FrictionClosure& closure) {
  const Index n = problem.coefficient.size();
  const VectorXd rounding = rounding_of(problem, closure);
  for (const Index i : rows.free) {
    if (std::abs(closure.movement(i)) > 4 * rounding(i)) return false;
    closure.movement(i) = 0;
  }
  closure.solvable = true;
  const double force_rounding = n == 0 ? 0
                                       : static_cast<double>(rows.free.size() + 1) * epsilon *
                                             closure.force.cwiseAbs().maxCoeff();
  for (Index i = 0; i < n; ++i) {
    const Motion motion = motions[static_cast<std::size_t>(i)];
    if (motion == Motion::Open && closure.movement(i) < -rounding(i)) return false;
    if (motion == Motion::Open) continue;
    if (closure.force(i) < -force_rounding) return false;
    const double bound = problem.coefficient(i) * closure.force(i) + problem.cohesion(i);
    if (motion == Motion::Stick &&
        std::abs(closure.force(n + i)) > bound + (1 + problem.coefficient(i)) * force_rounding)
      return false;
    if (bound > 0 && friction_sign(motion) * closure.movement(n + i) > rounding(n + i))
      return false;
  }
  closure.force.head(n) = closure.force.head(n).cwiseMax(0.0);
  closure.movement.head(n) = closure.movement.head(n).cwiseMax(0.0);
  const FrictionProblem same{problem.compliance,  problem.free.head(n), problem.free.tail(n),
                             problem.coefficient, problem.cohesion,     problem.rigid,
                             problem.resultant};
  FrictionState state;
  state.force = closure.force.head(n);
  state.friction = closure.force.tail(n);
  state.gap = closure.movement.head(n);
  state.slip = closure.movement.tail(n);
  state.amplitude = closure.amplitude;
  // The bound of a solution is 1e-12; in the units of the problem every number is rounded once more.
  return certify(same, state).holds(0.25e-12);
}

}  // namespace

Index predict_motions(const ScaledFriction& problem, const VectorXd& force,
                      const VectorXd& movement, double reach, std::vector<Motion>& motions) {
  const Index n = problem.coefficient.size();
  Index changes = 0;
  for (Index i = 0; i < n; ++i) {
    const double pressed = reach * force(i) - movement(i);
    const double bound = problem.coefficient(i) * pressed + reach * problem.cohesion(i);
    const double pulled = reach * force(n + i) - movement(n + i);
    Motion motion = Motion::Open;
    if (pressed > 0)
      motion = pulled > bound    ? Motion::Backward
               : pulled < -bound ? Motion::Forward
                                 : Motion::Stick;
    Motion& last = motions[static_cast<std::size_t>(i)];
    if (motion != last) ++changes;
    last = motion;
  }
  return changes;
}

FrictionClosure close_friction(const ScaledFriction& problem, const std::vector<Motion>& motions,
                               const VectorXd& force, const VectorXd& amplitude) {
  const Rows rows = rows_of(motions);
  FrictionClosure closure;
  closure.force = force;
  closure.amplitude = amplitude;
  const Index n = problem.coefficient.size();
  for (const Index i : rows.contacts)  // nothing that is huge may be left in a refined sum
    if (!std::isfinite(force(i)) || !std::isfinite(force(n + i))) closure.force.setZero();
  impose(problem, motions, closure.force);
  const MatrixXd A = system_of(problem, motions, rows);
  const LuFactor factor(A.rows() > 0 ? A : MatrixXd::Identity(1, 1));
  const bool regular = factor.rcond() > static_cast<double>(A.rows() + 1) * epsilon;
  const MatrixXd inverse = regular ? MatrixXd() : pseudo_inverse(A);
  for (int step = 0; step < 4 && A.rows() > 0; ++step) {
    const VectorXd left = residual(problem, rows, closure);
    correct(problem, motions, rows, regular ? factor.solve(left) : VectorXd(inverse * left),
            closure);
  }
  static_cast<void>(residual(problem, rows, closure));
  if (!closure.force.allFinite() || !closure.movement.allFinite()) return closure;
  closure.reversed =
      regular && A.rows() > 0 && negative(factor) != (problem.resultant.size() % 2 == 1);
  closure.confirmed = confirm(problem, motions, rows, closure);
  return closure;
}

}  // namespace signorini

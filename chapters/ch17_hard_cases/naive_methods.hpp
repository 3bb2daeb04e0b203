/// \file
/// Chapter 17: methods without safeguards, as they are often written, for the condensed problem.
#pragma once
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "papers/solver_table.hpp"
#include "signorini/problem/active_set_system.hpp"

namespace museum {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using signorini::ContactProblem;
using signorini::ContactState;
using signorini::SolveStatus;

/// Gaps of given forces, as the method computes them. \param problem  condensed \param[in,out] state  forces and amplitudes
inline void find_gaps(const ContactProblem& problem, ContactState& state) {
  state.gap = problem.free_gap + problem.compliance * state.force;
  if (problem.rigid.cols() > 0) state.gap += problem.rigid * state.amplitude;
}

/// Forces of a set of closed pairs, by Gauss's elimination.
/// \param problem  without friction
/// \param closed   pairs
/// \param spring   compliance of a spring in each contact [length/force]: 0, or that of a penalty
/// \return `n_c` forces and `n_r` amplitudes; not finite if elimination meets a zero
inline VectorXd eliminated(const ContactProblem& problem, const std::vector<Index>& closed,
                           double spring) {
  const Index n = problem.free_gap.size(), modes = problem.rigid.cols();
  const Index k = static_cast<Index>(closed.size());
  MatrixXd system = MatrixXd::Zero(k + modes, k + modes);
  VectorXd right(k + modes), all = VectorXd::Zero(n + modes);
  system.topLeftCorner(k, k) = problem.compliance(closed, closed);
  system.topLeftCorner(k, k).diagonal().array() += spring;
  right.head(k) = -problem.free_gap(closed);
  if (modes > 0) {
    system.topRightCorner(k, modes) = problem.rigid(closed, Eigen::all);
    system.bottomLeftCorner(modes, k) = system.topRightCorner(k, modes).transpose();
    right.tail(modes) = problem.resultant;
  }
  if (k + modes > 0) right = Eigen::PartialPivLU<MatrixXd>(system).solve(right).eval();
  for (Index i = 0; i < k; ++i) all(closed[static_cast<std::size_t>(i)]) = right(i);
  all.tail(modes) = right.tail(modes);
  return all;
}

// [guess]
/// Active sets by trial and error: drop what pulls, add what overlaps.
/// \param problem  without friction
/// \param spring   as above
/// \param overlap  that counts as none [length]
/// \return the last state; solved if no sign is wrong in it
inline ContactState trial_and_error(const ContactProblem& problem, double spring, double overlap) {
  const Index n = problem.free_gap.size();
  ContactState state;
  std::vector<Index> closed;
  for (Index i = 0; i < n; ++i)
    if (problem.free_gap(i) < -overlap) closed.push_back(i);
  for (int step = 0; step < 100; ++step) {
    const VectorXd found = eliminated(problem, closed, spring);
    if (!found.allFinite()) break;
    state.force = found.head(n);
    state.amplitude = found.tail(problem.rigid.cols());
    find_gaps(problem, state);
    std::vector<Index> next;
    for (Index i = 0; i < n; ++i)
      if (state.force(i) > 0 || (state.force(i) == 0 && state.gap(i) < -overlap)) next.push_back(i);
    state.report.status = next == closed ? SolveStatus::Solved : SolveStatus::IterationLimit;
    if (next == closed) break;
    closed = next;
  }
  state.contact_status = signorini::statuses_of(closed, n);
  return state;
}
// [guess]

/// Newton's method on gap and force as they are, a length beside a force: no scaling, no search along the line.
/// \param problem   without friction
/// \param relative  the residual must come below 1e-8 of the first one, else below 1e-8
/// \return the last state
inline ContactState newton_unscaled(const ContactProblem& problem, bool relative) {
  const Index n = problem.free_gap.size(), modes = problem.rigid.cols();
  ContactState state;
  state.force = VectorXd::Zero(n);
  state.amplitude = VectorXd::Zero(modes);
  state.report.status = SolveStatus::IterationLimit;
  double wanted = 1e-8;
  for (int step = 0; step < 100; ++step) {
    find_gaps(problem, state);
    const Eigen::ArrayXd a = state.gap.array(), b = state.force.array();
    const Eigen::ArrayXd root = (a.square() + b.square()).sqrt();
    VectorXd residual(n + modes);
    residual.head(n) = root - a - b;
    MatrixXd system = MatrixXd::Zero(n + modes, n + modes);
    const VectorXd da = a / root - 1, db = b / root - 1;
    system.topLeftCorner(n, n) = da.asDiagonal() * problem.compliance;
    system.topLeftCorner(n, n).diagonal() += db;
    if (modes > 0) {
      residual.tail(modes) = problem.rigid.transpose() * state.force - problem.resultant;
      system.topRightCorner(n, modes) = da.asDiagonal() * problem.rigid;
      system.bottomLeftCorner(modes, n) = problem.rigid.transpose();
    }
    if (relative && step == 0) wanted *= residual.norm();
    if (residual.norm() < wanted) {
      state.report.status = SolveStatus::Solved;
      return state;
    }
    const VectorXd change = Eigen::PartialPivLU<MatrixXd>(system).solve(residual);
    state.force -= change.head(n);
    state.amplitude -= change.tail(modes);
  }
  return state;
}

/// Friction without iteration: forces without friction first, then bounds of friction from them.
/// \param problem  with friction \return the state, claimed to be that of the whole
inline ContactState uncoupled(const ContactProblem& problem) {
  const std::string solver = "primal_dual_active_set";
  ContactProblem step = problem;
  step.law.coefficient.setZero();
  step.law.cohesion.setZero();
  ContactState state = signorini::find_solver(solver).solve(step, {});
  if (state.report.status != SolveStatus::Solved) return state;
  step.law.cohesion =
      problem.law.cohesion + problem.law.coefficient.cwiseProduct(state.force(problem.law.pair));
  return signorini::find_solver(solver).solve(step, {});
}

/// Pair by pair, the force that closes the gap, then the friction that stops the slip, up to its bound; a hundred times, or
/// until nothing changes by more than 1e-6. Cohesion holds open pairs, too, \PaperEq{LinEtAl, 29}.
/// \param problem  with friction, of held bodies \return the state
inline ContactState sweeps(const ContactProblem& problem) {
  const Index n = problem.free_gap.size();
  VectorXd free(n + problem.free_slip.size()), all = VectorXd::Zero(free.size());
  free << problem.free_gap, problem.free_slip;
  ContactState state;
  state.report.status = SolveStatus::IterationLimit;
  for (int sweep = 0; sweep < 100 && state.report.status != SolveStatus::Solved; ++sweep) {
    double change = 0;
    for (Index i = 0; i < all.size(); ++i) {
      const double moved = free(i) + problem.compliance.row(i).dot(all);
      const double wanted = all(i) - moved / problem.compliance(i, i);
      const Index k = i - n;
      const double bound =
          k < 0 ? 0
                : problem.law.coefficient(k) * all(problem.law.pair[static_cast<std::size_t>(k)]) +
                      problem.law.cohesion(k);
      const double next = k < 0 ? std::max(wanted, 0.0) : std::clamp(wanted, -bound, bound);
      change = std::max(change, std::abs(next - all(i)));
      all(i) = next;
    }
    if (change < 1e-6) state.report.status = SolveStatus::Solved;
  }
  const VectorXd moved = free + problem.compliance * all;
  state.force = all.head(n);
  state.gap = moved.head(n);
  state.friction = all.tail(all.size() - n);
  state.slip = moved.tail(all.size() - n);
  return state;
}

}  // namespace museum

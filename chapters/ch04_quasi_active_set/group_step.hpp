// What to keep of the method: whole groups close at once, with the first energy and with all forces.
#pragma once
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/problem.hpp"

namespace ch04 {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using signorini::ContactProblem;
using Rows = std::vector<Index>;

/// Forces, of any sign, that close given pairs of the gaps d + G lambda; 0 elsewhere.
inline VectorXd close(const ContactProblem& problem, const Rows& rows) {
  VectorXd force = VectorXd::Zero(problem.free_gap.size());
  const MatrixXd G = problem.compliance(rows, rows);
  force(rows) = -G.llt().solve(problem.free_gap(rows));
  return force;
}

inline double dual_energy(const ContactProblem& problem, const VectorXd& force) {
  return -force.dot(0.5 * (problem.compliance * force) + problem.free_gap);
}

template <typename Which>
bool drop(Rows& rows, const Which& which) {
  const std::size_t before = rows.size();
  rows.erase(std::remove_if(rows.begin(), rows.end(), which), rows.end());
  return rows.size() < before;
}

/// Pairs that overlap beyond rounding under given forces, the worst first.
inline Rows violated_pairs(const ContactProblem& problem, const VectorXd& force) {
  const VectorXd gap = problem.free_gap + problem.compliance * force;
  const double small = 1e-12 * problem.free_gap.cwiseAbs().maxCoeff();
  Rows violated;
  for (Index i = 0; i < gap.size(); ++i)
    if (gap(i) < -small) violated.push_back(i);
  std::sort(violated.begin(), violated.end(), [&](Index a, Index b) { return gap(a) < gap(b); });
  return violated;
}

/// Proposes the closed pairs, and the violated ones, worst first, that do not depend on those before.
inline Rows propose(const ContactProblem& problem, const VectorXd& force, const Rows& violated) {
  Rows rows;
  for (Index i = 0; i < force.size(); ++i)
    if (force(i) > 0) rows.push_back(i);
  const std::size_t closed = rows.size();
  for (const Index i : violated) {
    rows.push_back(i);
    const auto factor = problem.compliance(rows, rows).llt();
    const Index last = factor.rows() - 1;
    const double rest =  // what is new in row i
        factor.info() == Eigen::Success ? std::pow(factor.matrixLLT()(last, last), 2) : 0;
    if (!(rest > std::sqrt(signorini::epsilon) * problem.compliance(i, i))) rows.pop_back();
  }
  if (rows.size() == closed)
    throw signorini::NotSolved(
        "all violated pairs depend on the closed ones: exchange one of them");
  return rows;
}

/// The forces grow from the old ones towards those that close the group, and what pulls opens on the way.
inline VectorXd with_care(const ContactProblem& problem, VectorXd force, Rows rows) {
  for (;;) {
    const VectorXd goal = close(problem, rows);
    const auto way = [&](Index i) { return goal(i) < 0 ? force(i) / (force(i) - goal(i)) : 1; };
    double t = 1;  // as far towards the goal as nothing pulls
    for (const Index i : rows) t = std::min(t, way(i));
    if (t == 1) return goal;
    drop(rows, [&](Index i) { return way(i) <= t; });  // at least one of those that pull
    const VectorXd there = force + t * (goal - force);
    force.setZero();
    force(rows) = there(rows);
  }
}

// [group step]
/// Closes a group at once, opens what pulls, closes the rest, and so on until none pulls.
inline VectorXd at_once(const ContactProblem& problem, Rows rows) {
  VectorXd force = close(problem, rows);
  while (drop(rows, [&](Index i) { return force(i) < 0; })) force = close(problem, rows);
  return force;
}

/// A group joins: at once, and if that was too bold, with care.
inline VectorXd group_step(const ContactProblem& problem, const VectorXd& old, const Rows& group) {
  const VectorXd bold = at_once(problem, group);
  const bool higher = dual_energy(problem, bold) > dual_energy(problem, old);
  return higher ? bold : with_care(problem, old, group);
}
// [group step]

}  // namespace ch04

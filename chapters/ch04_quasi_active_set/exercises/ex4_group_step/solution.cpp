#include <algorithm>

#include "exercise.hpp"

namespace ex4_4 {

using Eigen::Index;
using Eigen::VectorXd;
using signorini::ContactProblem;

namespace {

// G_ii - G_iW G_WW^-1 G_Wi: how far pair i still moves under a unit force when the rows W are closed.
double rest_of(const ContactProblem& problem, Index i, const Rows& rows) {
  const Eigen::MatrixXd& G = problem.compliance;
  if (rows.empty()) return G(i, i);
  const VectorXd others = G(rows, i);
  return G(i, i) - others.dot(signorini::CholeskyFactor(G(rows, rows)).solve(others));
}

double dual_energy(const ContactProblem& problem, const VectorXd& force) {
  return -force.dot(problem.free_gap + 0.5 * (problem.compliance * force));
}

template <typename Which>
bool open(Rows& rows, const Which& which) {
  const std::size_t before = rows.size();
  rows.erase(std::remove_if(rows.begin(), rows.end(), which), rows.end());
  return rows.size() < before;
}

}  // namespace

Rows group_of(const ContactProblem& problem, const VectorXd& force) {
  const VectorXd gap = problem.free_gap + problem.compliance * force;
  Rows group, overlap;
  for (Index i = 0; i < gap.size(); ++i) {
    if (force(i) > 0) group.push_back(i);
    if (force(i) <= 0 && gap(i) < -1e-10) overlap.push_back(i);
  }
  std::stable_sort(overlap.begin(), overlap.end(),
                   [&](Index i, Index k) { return gap(i) < gap(k); });
  for (const Index i : overlap)
    if (rest_of(problem, i, group) > 1e-8 * problem.compliance(i, i)) group.push_back(i);
  return group;
}

Round group_step(const ContactProblem& problem, const VectorXd& old, const Rows& group) {
  Rows rows = group;
  VectorXd goal = close(problem, rows);
  while (open(rows, [&](Index i) { return goal(i) < 0; })) goal = close(problem, rows);
  if (dual_energy(problem, goal) > dual_energy(problem, old)) return {goal, true};

  VectorXd force = old;
  rows = group;
  goal = close(problem, rows);
  while (goal.minCoeff() < 0) {
    VectorXd part = VectorXd::Ones(goal.size());  // of the way that each force can go
    for (const Index i : rows)
      if (goal(i) < 0) part(i) = force(i) / (force(i) - goal(i));
    const double shortest = part.minCoeff();
    force += shortest * (goal - force);
    open(rows, [&](Index i) { return goal(i) < 0 && part(i) == shortest; });
    for (Index i = 0; i < force.size(); ++i)
      if (goal(i) < 0 && part(i) == shortest) force(i) = 0;
    goal = close(problem, rows);
  }
  return {goal, false};
}

}  // namespace ex4_4

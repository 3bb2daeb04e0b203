// Chapter 4 - What to keep: whole groups close at once, with the first energy and with all forces.
// Run:  make ch04     Reads: nothing     Writes: ch04_group_step.results
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "cases.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/examples.hpp"
#include "signorini/report/program.hpp"

namespace {

using namespace signorini;
using namespace ch04;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Rows = std::vector<Index>;

/// Forces, of any sign, that close given pairs of the gaps d + G lambda; 0 elsewhere.
VectorXd close(const ContactProblem& problem, const Rows& rows) {
  VectorXd force = VectorXd::Zero(problem.free_gap.size());
  const MatrixXd G = problem.compliance(rows, rows);
  force(rows) = -G.llt().solve(problem.free_gap(rows));
  return force;
}

double dual_energy(const ContactProblem& problem, const VectorXd& force) {
  return -force.dot(0.5 * (problem.compliance * force) + problem.free_gap);
}

template <typename Which>
bool drop(Rows& rows, const Which& which) {
  const std::size_t before = rows.size();
  rows.erase(std::remove_if(rows.begin(), rows.end(), which), rows.end());
  return rows.size() < before;
}

// 1. Propose: the closed pairs, and the violated ones, worst first, that do not depend on those before.
Rows propose(const ContactProblem& problem, const VectorXd& force, const Rows& violated) {
  Rows rows;
  for (Index i = 0; i < force.size(); ++i)
    if (force(i) > 0) rows.push_back(i);
  for (const Index i : violated) {
    rows.push_back(i);
    const MatrixXd L = problem.compliance(rows, rows).llt().matrixL();
    const double rest = std::pow(L(L.rows() - 1, L.rows() - 1), 2);  // what is new in row i
    if (!(rest > std::sqrt(epsilon) * problem.compliance(i, i))) rows.pop_back();
  }
  return rows;
}

// 2. The group joins at once. If that was too bold, the forces grow from the old ones.
// [group step]
VectorXd group_step(const ContactProblem& problem, const VectorXd& old, const Rows& group) {
  Rows rows = group;  // closed pairs and those that join
  VectorXd goal = close(problem, rows);
  const auto pulls = [&](Index i) { return goal(i) < 0; };
  while (drop(rows, pulls)) goal = close(problem, rows);
  if (dual_energy(problem, goal) > dual_energy(problem, old)) return goal;  // accepted

  rows = group;
  for (VectorXd force = old;;) {
    goal = close(problem, rows);
    const auto way = [&](Index i) { return pulls(i) ? force(i) / (force(i) - goal(i)) : 1; };
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

// 3. Rounds, until no pair overlaps.
Index solve_in_groups(const ContactProblem& problem, VectorXd& force) {
  force.setZero(problem.free_gap.size());
  const double small = 1e-12 * problem.free_gap.cwiseAbs().maxCoeff();
  for (Index round = 0;; ++round) {
    const VectorXd gap = problem.free_gap + problem.compliance * force;
    Rows violated;
    for (Index i = 0; i < gap.size(); ++i)
      if (gap(i) < -small) violated.push_back(i);
    if (violated.empty()) return round;
    std::sort(violated.begin(), violated.end(), [&](Index a, Index b) { return gap(a) < gap(b); });
    const Rows group = propose(problem, force, violated);
    if (static_cast<Index>(group.size()) == (force.array() > 0).count())
      throw NotSolved("all violated pairs depend on the closed ones: exchange one of them");
    force = group_step(problem, force, group);
  }
}

Status chapter(const ProgramOptions& run) {
  Results results("ch04_group_step");
  VectorXd force;
  results.add("repaired_steps", static_cast<double>(solve_in_groups(condensed(four_walls), force)),
              "-");
  const VectorXd u = displacement(four_walls, force);
  results.add("repaired_energy", 0.5 * u.dot(u) - floating(four_walls.p).dot(u), "-");
  const KnownProgramme known = rosen_suzuki(50, 50, 1);
  results.add("group_rounds",
              static_cast<double>(solve_in_groups(condense(known.programme).problem, force)), "-");
  results.add("group_error", (force - known.force).norm() / known.force.norm(), "-", Repeats::No);
  results.print();
  results.write(run.out);
  return Status::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch04_group_step", "Groups", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}

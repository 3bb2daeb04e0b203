// Where the printed and the repaired method are after each of their steps.
#pragma once
#include "cases.hpp"
#include "group_step.hpp"
#include "papers/examples.hpp"
#include "signorini/core/table.hpp"
#include "signorini/solvers/quasi_active_set.hpp"
#include "which_rows.hpp"

namespace ch04 {

using namespace signorini;

/// After a step.
struct Stage {
  Rows taken;      ///< pairs that the step works with
  Rows pressed;    ///< those of them that got a force
  VectorXd force;  ///< of all steps together
  VectorXd gap;
};

/// All steps on one problem.
struct Way {
  ContactProblem problem;
  VectorXd best;              ///< forces of the solution
  std::vector<Stage> stages;  ///< the start first
  Index rounds = 0;           ///< steps of the loop
  bool optimal = true;        ///< whether the end is the solution
};

/// Pairs that press. \param force  `n_c` [force] \return their numbers, in increasing order
inline Rows with_force(const VectorXd& force) {
  Rows pressed;
  for (Index i = 0; i < force.size(); ++i)
    if (force(i) > 0) pressed.push_back(i);
  return pressed;
}

/// A way at its start, where no pair has a force.
/// \param problem  without friction \return the way, which also knows the forces of the solution
inline Way begin(const ContactProblem& problem) {
  const VectorXd best = quasi_active_set(problem).force;
  return {problem, best, {{{}, {}, 0 * best, problem.free_gap}}};
}

/// Adds a step. \param way  gets it \param taken,pressed  see Stage \param force  `n_c`, of all steps together [force]
inline void go_on(Way& way, const Rows& taken, const Rows& pressed, const VectorXd& force) {
  const ContactProblem& problem = way.problem;
  way.stages.push_back({taken, pressed, force, problem.free_gap + problem.compliance * force});
}

/// Largest overlap that is left, 0 if it is rounding.
inline double overlap_left(const Way& way, const Stage& at) {
  const double first = -way.problem.free_gap.minCoeff();
  return -at.gap.minCoeff() > 1e-9 * first ? -at.gap.minCoeff() : 0;
}

/// Potential energy above that of the solution, 0 if it is rounding: half of the work that forces do in G.
inline double energy_above(const Way& way, const Stage& at) {
  const auto half = [&way](const VectorXd& f) { return 0.5 * f.dot(way.problem.compliance * f); };
  const double above = half(at.force) - half(way.best);
  return std::abs(above) > 1e-9 * half(way.best) ? above : 0;
}

/// What can be said of a stage.
inline std::string words_for(const Way& way, std::size_t step) {
  if (step + 1 == way.stages.size())
    return way.optimal ? "The end is the solution."
                       : "Nothing overlaps, but there is less energy elsewhere.";
  if (overlap_left(way, way.stages[step]) == 0) return "Nothing overlaps: the last step follows.";
  for (std::size_t before = step; before > 1; --before)
    if (way.stages[before - 1].taken == way.stages[step].taken)
      return text("The pairs of step ", before - 1, " were taken once more.");
  return "Some pairs still overlap.";
}

/// Rounds of group steps, which keep all forces.
inline Way repaired_way(const ContactProblem& problem) {
  Way way = begin(problem);
  for (VectorXd force = way.stages[0].force;; ++way.rounds) {
    const Rows violated = violated_pairs(problem, force);
    if (violated.empty()) return way;
    Rows group = propose(problem, force, violated);
    force = group_step(problem, force, group);
    std::sort(group.begin(), group.end());
    go_on(way, group, with_force(force), force);
  }
}

/// The loop that moves the minimum, and (33)-(35) as one step more.
inline Way printed_way(const ContactProblem& problem, QuasiActiveRows rows) {
  Way way = begin(problem);
  const QuasiActiveRun run = run_quasi_active_set_literal(problem, {}, rows);
  for (const QuasiActiveStep& step : run.steps) {
    const Stage old = way.stages.back();  // (31): the free gaps are the present ones
    const VectorXd more = close({problem.compliance, old.gap}, step.closed);
    go_on(way, step.quasi_active, step.closed, old.force + more);
  }
  go_on(way, run.tight, with_force(run.state.force), run.state.force);
  way.rounds = run.outer_steps;
  way.optimal = run.state.report.status == SolveStatus::Solved;
  return way;
}

}  // namespace ch04

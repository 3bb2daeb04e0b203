// Chapter 4 - What to keep: whole groups close at once, with the first energy and with all forces.
// Run:  make ch04     Reads: nothing     Writes: ch04_group_step.results
#include "group_step.hpp"

#include "cases.hpp"
#include "papers/examples.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;
using namespace ch04;

// 1. Rounds, until no pair overlaps.
Index solve_in_groups(const ContactProblem& problem, VectorXd& force) {
  force.setZero(problem.free_gap.size());
  for (Index round = 0;; ++round) {
    const Rows violated = violated_pairs(problem, force);
    if (violated.empty()) return round;
    force = group_step(problem, force, propose(problem, force, violated));
  }
}

SolveStatus chapter(const ProgramOptions& run) {
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
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch04_group_step", "Groups", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}

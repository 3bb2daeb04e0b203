// Chapter 4 - The last step (Xuan & Li 2002, eqs. 33-35), which the paper calls optimal, on four walls in space.
// Run:  make ch04     Reads: nothing     Writes: ch04_last_step.results, last_step.md
#include "last_step.hpp"

#include "cases.hpp"
#include "papers/quasi_active_set_literal.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;
using namespace ch04;

// 1. From where the loop stops in floating point, and what its forces say of the end.
SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch04_last_step");
  const exact::Programme& q = four_walls;
  const ContactProblem problem = condensed(q);
  const QuasiActiveRun way = run_quasi_active_set_literal(problem);
  SolverOptions stop;
  stop.iteration_limit = way.outer_steps - 1;
  const Eigen::VectorXd u = displacement(q, quasi_active_set_literal(problem, stop).force);
  for (const Eigen::Index i : {0, 1, 2}) results.add(text("limit_", i + 1), u(i), "-");
  results.add("walls_steps", static_cast<double>(way.outer_steps), "-");
  results.add("walls_delta", way.fraction, "-");
  results.add("last_step_bound", energy_gap(way.state), "-");

  // 2. Exactly: rows 3 and 4 are tight on a line, from whose points the last step ends at (1, 1, 1).
  const auto [next, delta, end] = last_step(q, exact::along({1, 1, 1}, {1, 50}, {6, 3, -1}));
  const exact::Rest held =
      solve_active_set(q, rows_with(q, end, 0), q.p);  // the forces that hold the end
  const exact::Rest best = closest(q, {0, 1, 2, 3}, q.p);
  Table table({"", "u", "energy", "forces of the rows"});
  table.row({"(33)", text_of(next.u), energy(q, next.u).text(), text_of(next.force)});
  table.row({"(35)", text_of(end), energy(q, end).text(), text_of(held.force)});
  table.row({"optimum", text_of(best.u), energy(q, best.u).text(), text_of(best.force)});
  write_file(run.out / "last_step.md", table.markdown());
  results.add("last_step_energy", energy(q, end).value(), "-");
  results.add("last_step_excess", (energy(q, end) - energy(q, best.u)).value(), "-");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch04_last_step", "The last step", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}

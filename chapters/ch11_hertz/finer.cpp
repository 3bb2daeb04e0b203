// Chapter 11 - Finer meshes, and the iterations of three solvers.
// Run:  make ch11     Reads: nothing     Writes: ch11_finer.results, refinement.md, solvers.md
#include <iostream>

#include "hertz_run.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/solvers/fischer_burmeister.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"
#include "signorini/solvers/quasi_active_set.hpp"

namespace {

using namespace signorini;

const double b = hertz_half_width(HertzCase{}.theory());

// 1. The errors on three meshes.
void refinement(const ProgramOptions& run, Results& results) {
  Table table(
      {"nodes", "edges on b", "iterations", "q0 [%]", "b [%]", "rms p [%]", "sinks by [mm]"});
  for (const HertzCase& now : {HertzCase{}, finer(32, 24, 30), finer(64, 48, 60)}) {
    const HertzRun out = solve_hertz(now);
    results.add(text("width_", now.mesh.disc_cells), out.b_error, "%");
    results.add(text("rms_", now.mesh.disc_cells), pressure_error(out), "%");
    table.row({std::to_string(count_nodes(out.run.model.bodies)), number(b / out.x[1], "%.1f"),
               std::to_string(out.run.solution.contact.report.iterations), percent(out.q_error),
               percent(out.b_error), number(pressure_error(out), "%.3f"),
               number(sinking(out.run, 1), "%.5f")});
  }
  std::cout << table.markdown();
  write_file(run.out / "refinement.md", table.markdown());
}

// 2. The same condensed problems by three solvers.
void iterations(const ProgramOptions& run) {
  const HertzRun small = solve_hertz({}), large = solve_hertz(finer(64, 48, 60));
  Table table({"solver", "1.4k nodes", "20k nodes"});
  for (const Solver& solver :
       {fischer_burmeister(), primal_dual_active_set(), quasi_active_set()}) {
    std::vector<std::string> row = {solver.name};
    for (const SolvedScene* scene : {&small.run, &large.run}) {
      const Solution found = solve(scene->model, scene->condensed, solver, {});
      require_solved(found, solver.name);
      row.push_back(std::to_string(found.contact.report.iterations));
    }
    table.row(row);
  }
  std::cout << table.markdown();
  write_file(run.out / "solvers.md", table.markdown());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch11_finer");
  refinement(run, results);
  iterations(run);
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch11_finer", "Finer meshes", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}

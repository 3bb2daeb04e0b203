// Chapter 6 - The method of the paper as it is printed, on so few cells that each node can be drawn.
// Run:  make ch06     Reads: nothing     Writes: ch06_as_printed.results, fig_6_1.csv, fig_6_5_*.csv
#include "papers/field_csv.hpp"
#include "papers/printed_method.hpp"
#include "scene.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch06;

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch06_as_printed");
  const SolvedScene beam = solve_cantilever(paper, "q4_incompatible", 50);
  const PrintedMethod printed = printed_method(beam.condensed.problem);
  int one_step = 0;
  Index pressing = 0;  // entries of G by which a force that lifts a node presses another one down
  for (const Index cells : {50, 100, 200}) {
    const SolvedScene now = solve_cantilever(paper, "q4_incompatible", cells);
    one_step += solved_in_one_step(now.condensed.problem, now.solution.contact) ? 1 : 0;
    pressing += (now.condensed.problem.compliance.array() < 0).count();
  }
  results.add("one_step_meshes", one_step, "-");
  results.add("pressing_entries", static_cast<double>(pressing), "-");
  const BodyModel& body = beam.model.bodies[0];
  const Eigen::VectorXd x = beam.model.pairs.position.col(0);
  write_printed_method(run.out / "fig_6_5", printed, x);
  write_file(run.out / "fig_6_1.csv",  // the mesh before loading
             deformed_cells_csv(body.mesh, beam.solution.displacements[0],
                                Eigen::VectorXd::Zero(body.mesh.n_cells()), 0));
  add_counts(results, printed);
  results.add("printed_first", x(printed.group.front()), "cm");
  results.add("printed_deepest", -beam.condensed.problem.free_gap.minCoeff(), "cm");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch06_as_printed", "The printed method", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}

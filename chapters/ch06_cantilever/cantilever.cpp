// Chapter 6 - A cantilever on a rigid foundation (Xuan & Li 2002, sec. 4, example 2): its contact force.
// Run:  make ch06     Reads: nothing     Writes: ch06.results, history.md, fig_6_2.csv, fig_6_2_body.csv
#include "scene.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch06;

// 1. The load history: nothing touches, the tip touches, a line touches.
void load_history(const ProgramOptions& run, Results& results) {
  Table table({"q [kN/cm²]", "closed nodes", "force [kN]", "Euler-Bernoulli", "Timoshenko"});
  Table beams({"q", "euler_bernoulli", "timoshenko"});
  Table body({"q", "force", "euler_bernoulli"});
  for (int step = 0; step <= 100; ++step) {
    BeamOnFoundation beam = paper;
    beam.pressure = 0.04 * step;
    const double thin = euler_bernoulli(beam).total_force;
    const double thick = timoshenko(beam).total_force;
    beams.row({beam.pressure, thin, thick});
    if (step % 5 != 0) continue;  // every 0.2
    const SolvedScene now = solve_cantilever(beam, "q4_incompatible", 100);
    const double force = total_force(now);
    body.row({beam.pressure, force, thin});
    if (step == 5 || step == 25 || step == 50 || step == 90)
      table.row({number(beam.pressure, "%.1f"), std::to_string(now.solution.contact.active().size()),
                 number(force, "%.3f"), number(thin, "%.3f"), number(thick, "%.3f")});
    if (step == 25) results.add("tip_force", force, "kN");
  }
  write_file(run.out / "history.md", table.markdown());
  write_file(run.out / "fig_6_2.csv", beams.csv());
  write_file(run.out / "fig_6_2_body.csv", body.csv());
}

// 2. The load of the paper.
SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch06");
  load_history(run, results);
  const SolvedScene beam = solve_cantilever(paper, "q4_incompatible", 100);
  const ContactState& contact = beam.solution.contact;
  results.add("total_contact_force", total_force(beam), "kN");
  results.add("closed_nodes", static_cast<double>(contact.active().size()), "-");
  results.add("active_sets", static_cast<double>(contact.report.iterations), "-");
  results.add("coarse_sets",
              static_cast<double>(contact.report.factorisations - contact.report.iterations), "-");
  results.headline("total_contact_force", total_force_2d, "limit of finer meshes");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch06", "A cantilever on a rigid foundation", SIGNORINI_CHAPTER_OUT, argc,
                     argv, chapter);
}

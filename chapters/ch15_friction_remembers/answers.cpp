// Chapter 15 - Several answers to one load, and which one a step takes.
// Run:  make ch15     Reads: nothing     Writes: ch15_answers.results, fig_15_5.csv, fig_15_5_path.csv
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "wedge.hpp"

namespace {

using namespace ch15;

// All answers of one node, and the path that the steps take among them.
void fork(const ProgramOptions& run, Results& results) {
  Table all({"mu", "motion", "push", "slip"}), path({"mu", "time", "push", "slip"});
  for (const double coefficient : {1., 3.}) {
    for (const ContactStatus contact_status :
         {ContactStatus::Stick, ContactStatus::SlipForward, ContactStatus::Open}) {
      for (int i = 0; i <= 120; ++i)
        for (const Answer& answer : answers(coefficient, i / 150.))
          if (answer.contact_status == contact_status)
            all.row({number(coefficient), to_string(contact_status), number(i / 150.),
                     number(answer.slip)});
      all.blank_line();
    }
    const Scene scene = wedge(coefficient);
    remember(scene, [&](const Model&, const Step& step) {
      const double push = scene.path->histories[1].at(step.state.time);
      path.row({coefficient, step.state.time, push, 1e3 * step.solution.displacements[0](1, 1)});
    });
  }
  for (const Answer& answer : answers(3, 0.5))
    results.add(text("slip_", to_string(answer.contact_status)), answer.slip, "um");
  write_file(run.out / "fig_15_5.csv", all.csv());
  write_file(run.out / "fig_15_5_path.csv", path.csv());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch15_answers");
  fork(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch15_answers", "Several answers", SIGNORINI_CHAPTER_OUT, argc,
                                argv, chapter);
}

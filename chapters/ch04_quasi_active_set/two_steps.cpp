// Chapter 4 - Three rows in a plane: loops that leave violated rows out end after two steps.
// Run:  make ch04     Reads: nothing     Writes: ch04_two_steps.results, two_steps.md
#include "cases.hpp"
#include "last_step.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "which_rows.hpp"

namespace {

using namespace signorini;
using namespace ch04;

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch04_two_steps");
  Table table({"QAS", "its rows", "u¹", "its rows", "u²", "end of (35)"});
  const ContactProblem problem = condensed(fan);
  for (const Choice& choice : choices) {
    // 1. The rows are chosen in floating point; where they lead is exact.
    const QuasiActiveRun way = run_quasi_active_set_literal(problem, {}, choice.rows);
    std::vector<std::string> cells{choice.name};
    exact::Vector u = fan.p;
    for (const QuasiActiveStep& step : way.steps) {
      const exact::Set rows(step.quasi_active.begin(), step.quasi_active.end());
      u = closest(fan, rows, u).u;
      cells.push_back(text_of(rows));
      cells.push_back(text_of(u));
    }
    cells.resize(5);
    // 2. The last step ends at the solution, which the loop has missed.
    const exact::Vector end = last_step(fan, u).end;
    cells.push_back(text_of(end));
    table.row(cells);
    if (choice.rows == QuasiActiveRows::IndependentByIndex) {
      results.add("two_steps_excess", (energy(fan, u) - energy(fan, end)).value(), "-");
    }
  }
  write_file(run.out / "two_steps.md", table.markdown());
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch04_two_steps", "Two steps", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}

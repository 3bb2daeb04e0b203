// Chapter 11 - Three ways to read b: the last closed node follows the grid, the other two do not.
// Run:  make ch11     Reads: nothing     Writes: ch11_half_width.results, grid.md
#include <iostream>

#include "hertz_run.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;

const double b = hertz_half_width(HertzCase{}.theory());

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch11_half_width");
  Table table({"core [mm]", "nodes on b", "last closed node", "fit", "second moment", "q0, fit"});
  double last = 0, fit = 0, moment = 0, peak = 0;  // the largest error of each [%]
  for (const double core : {1.3, 1.35, 1.4, 1.45, 1.5, 1.55, 1.6}) {
    HertzCase now;
    now.mesh.core = core;
    const HertzRun out = solve_hertz(now);
    const double last_error = 100 * (out.last_closed / b - 1);
    const double fit_error = 100 * (out.fit.half_width / b - 1);
    table.row({number(core, "%.2f"), number(b / out.x[1], "%.1f"), percent(last_error),
               percent(fit_error), percent(out.b_error), percent(out.q_error)});
    last = std::max(last, std::abs(last_error));
    fit = std::max(fit, std::abs(fit_error));
    moment = std::max(moment, std::abs(out.b_error));
    peak = std::max(peak, std::abs(out.q_error));
  }
  std::cout << table.markdown();
  write_file(run.out / "grid.md", table.markdown());
  results.add("worst_last", last, "%");
  results.add("worst_fit", fit, "%");
  results.add("worst_moment", moment, "%");
  results.add("worst_peak", peak, "%");
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch11_half_width", "Reading off a half-width", SIGNORINI_CHAPTER_OUT, argc,
                     argv, chapter);
}

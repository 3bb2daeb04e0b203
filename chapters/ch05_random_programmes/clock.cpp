// Chapter 5 - Table 1 as printed, what it says, and the clock behind its times: how many of their digits mean something.
// Run:  make ch05     Reads: nothing     Writes: ch05_clock.results, printed.md
#include <algorithm>
#include <cmath>

#include "../../tests/reference/rosen_suzuki_table_1.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;

// 1. The table, and at how many sizes the paper's method was quicker or slower, by what factors.
void printed(const ProgramOptions& run, Results& results) {
  Table table({"$`n`$", "$`m`$", "Lemke's method [s]", "the paper's [s]", "$`f_P/f_L`$"});
  std::vector<double> quicker, slower;
  for (const reference::RandomProgramme& line : reference::table_1) {
    table.row({std::to_string(line.n), std::to_string(line.m), number(line.lemke_seconds, "%.4f"),
               number(line.paper_seconds, "%.4f"), number(line.ratio, "%.9f")});
    const double times = line.lemke_seconds / line.paper_seconds;
    (times > 1 ? quicker : slower).push_back(std::max(times, 1 / times));
  }
  write_file(run.out / "printed.md", table.markdown());
  const reference::RandomProgramme& last = reference::table_1.back();
  results.add("quicker_50_200", last.lemke_seconds / last.paper_seconds, "-");
  results.add("paper_quicker", static_cast<double>(quicker.size()), "-");
  results.add("paper_slower", static_cast<double>(slower.size()), "-");
  results.add("quicker_from", *std::min_element(quicker.begin(), quicker.end()), "-");
  results.add("quicker_to", *std::max_element(quicker.begin(), quicker.end()), "-");
  results.add("slower_to", *std::max_element(slower.begin(), slower.end()), "-");
}

// 2. The clock of a personal computer ticked 1193182 / 65536 times a second.
SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch05_clock");
  printed(run, results);
  const double tick = 65536.0 / 1193182.0;  // [s]
  int times = 0;
  int near_ticks = 0;
  int in_256ths = 0;
  for (const reference::RandomProgramme& line : reference::table_1) {
    for (const double t : {line.lemke_seconds, line.paper_seconds}) {
      ++times;
      near_ticks += std::abs(t / tick - std::round(t / tick)) < 0.15 ? 1 : 0;
      in_256ths += std::abs(t - std::round(256 * t) / 256) < 0.51e-4 ? 1 : 0;  // 4 decimals printed
    }
  }
  results.add("clock_tick", 1000 * tick, "ms");
  results.add("printed_times", times, "-");
  results.add("times_near_ticks", near_ticks, "-");
  results.add("times_in_256ths", in_256ths, "-");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch05_clock", "The clock of table 1", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}

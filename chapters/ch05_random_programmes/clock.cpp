// Chapter 5 - The clock behind the times of table 1: how many of their digits mean something.
// Run:  make ch05     Reads: nothing     Writes: ch05_clock.results
#include <cmath>

#include "../../tests/reference/rosen_suzuki_table_1.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;

// The clock of a personal computer ticked 1193182 / 65536 times a second.
SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch05_clock");
  const double tick = 65536.0 / 1193182.0;  // [s]
  int times = 0;
  int near_ticks = 0;
  int in_256ths = 0;
  int slower = 0;
  for (const reference::RandomProgramme& line : reference::table_1) {
    slower += line.paper_seconds > line.lemke_seconds ? 1 : 0;
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
  results.add("paper_slower", slower, "-");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch05_clock", "The clock of table 1", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}

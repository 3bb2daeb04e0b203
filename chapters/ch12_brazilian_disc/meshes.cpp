// Chapter 12 - Two meshes refined: one fine in the middle, one fine at the poles.
// Run:  make ch12     Reads: nothing     Writes: meshes.md
#include <iostream>

#include "reading.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch12;

void refine(const ProgramOptions& run) {
  Table table({"fine at", "nodes", "middle [%]", "against (44) [%]", "axis [%]", "turns at [mm]"});
  for (const Division& division : {for_middle, for_axis})
    for (const double finer : {0.5, 1., 2.}) {
      if (division.grading > 1 && finer > 1) continue;  // 40000 nodes
      const SolvedScene now = solve_disc(division, finer);
      const double across = middle(now)[0];
      table.row({division.grading > 1 ? "poles" : "middle", std::to_string(nodes_of(now)),
                 number(100 * (across / exact_across(R) - 1), "%+.4f"),
                 number(100 * (across / strength - 1), "%+.4f"),
                 number(100 * axis_error(now), "%.2f"),
                 number(sign_change(diameter_of(now)), "%.3f")});
    }
  std::cout << table.markdown();
  write_file(run.out / "meshes.md", table.markdown());
}

SolveStatus chapter(const ProgramOptions& run) {
  refine(run);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch12_meshes", "Two meshes refined", SIGNORINI_CHAPTER_OUT, argc,
                                argv, chapter);
}

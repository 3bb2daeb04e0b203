// Chapter 1 - Contact by trial of all sets of closed pairs.
// Run:  make ch01     Reads: nothing     Writes: ch01_trial.results, candidates.md
#include <iostream>

#include "block_on_obstacle.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/scene/readings.hpp"
#include "signorini/solvers/enumerate.hpp"

namespace {

using namespace ch01;

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch01_trial");
  // 1. Nine candidates: all 2^9 sets of closed pairs are tried, and one fits.
  const SolvedScene block = solved(block_on_obstacle(8), "the block");
  const ContactState tried = enumerate(block.condensed.problem);
  if (tried.report.status != SolveStatus::Solved) throw NotSolved("no set of closed pairs fits");
  // 2. The right half of the base; the left one is its mirror image.
  const auto right = Eigen::seq(4, 8);
  const Table table =
      table_of({{"x [mm]", block.model.pairs.position.col(0)(right), "%.0f"},
                {"free gap [mm]", block.condensed.problem.free_gap(right), "%.3f"},
                {"gap [mm]", tried.gap(right), "%.3f"},
                {"contact force [N]", tried.force(right), "%.3f"}});
  write_file(run.out / "candidates.md", table.markdown());
  std::cout << table.markdown();
  results.add("small_candidates", static_cast<double>(tried.gap.size()), "-");
  results.add("small_closed", static_cast<double>(tried.active().size()), "-");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch01_trial", "Trying all sets of closed pairs", SIGNORINI_CHAPTER_OUT, argc,
                     argv, chapter);
}

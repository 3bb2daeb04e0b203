// Chapter 10 - The whole system with friction, at Gauss points, all displacements kept (Lin et al., sec. 2.4, eq. 42).
// Run:  make ch10     Reads: nothing     Writes: ch10_whole.results, whole.md
#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "whole_system.hpp"

namespace {

using namespace ch10;

// 1. How many points are pressed, and how many of these slide, by the parts of the slip.
std::pair<Index, Index> pressed_and_sliding(const WholeSystem& whole, const VectorXd& x) {
  const Index n = whole.run.model.programme.load.size(), m = whole.normal.cols();
  std::pair<Index, Index> count(0, 0);
  for (Index i = 0; i < m; ++i) {
    if (std::abs(x(n + i)) < 1e-9) continue;
    ++count.first;
    if (std::max(x(n + 2 * m + i), x(n + 3 * m + i)) > 1e-9) ++count.second;
  }
  return count;
}

// 2. Blocks pressed together and pushed to the side: all points stick, some slide, all slide.
void pushed(const ProgramOptions& run, Results& results) {
  Table table(
      {"push, over compression", "f_n is", "steps", "points", "pressed", "slide", "thrust / load"});
  for (const double side : {0.3, 1.0, 2.0}) {
    WholeSystem whole = whole_system(sheared_blocks(side));
    const Index n = whole.run.model.programme.load.size(), m = whole.normal.cols();
    const VectorXd weight = whole.run.model.pairs.weight;
    for (const auto reading : {NormalTraction::Pressure, NormalTraction::Stress}) {
      whole.reading = reading;
      const WholeRun way = newton(whole);
      if (!way.solved) throw NotSolved("(42) with friction: Newton's method did not arrive");
      const double load = weight.dot(way.x.segment(n, m));
      const double thrust = weight.dot(way.x.segment(n + m, m));
      const auto [pressed, slide] = pressed_and_sliding(whole, way.x);
      const Index steps = static_cast<Index>(way.residuals.size()) - 1;
      table.row({number(side), reading == NormalTraction::Pressure ? "pressure" : "stress",
                 std::to_string(steps), std::to_string(m), std::to_string(pressed),
                 std::to_string(slide), number(thrust / load, "%.3f")});
      if (side != 1 || reading == NormalTraction::Stress) continue;
      results.add("side", side, "-");
      results.add("unknowns", static_cast<double>(way.x.size()), "-");
      results.add("points", static_cast<double>(m), "-");
      results.add("steps", static_cast<double>(steps), "-");
      results.add("pressed", static_cast<double>(pressed), "-");
      results.add("slide", static_cast<double>(slide), "-");
      results.add("load", load, "-");
      results.headline("load", whole.run.solution.contact.force.sum(), "condensed");
    }
  }
  std::cout << table.markdown();
  write_file(run.out / "whole.md", table.markdown());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch10_whole");
  pushed(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch10_whole", "The whole system with friction", SIGNORINI_CHAPTER_OUT, argc,
                     argv, chapter);
}

// Chapter 12 - Hondros' arcs: what a width of the load costs in the middle, and near the load.
// Run:  make ch12     Reads: nothing     Writes: ch12_arcs.results, arcs.md
#include <cmath>
#include <iostream>

#include "reading.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch12;

// 1. The middle under uniform pressure on arcs of 2 alpha.
void compare_arcs(const ProgramOptions& run, Results& results) {
  Table table({"2α [°]", "chord [mm]", "σx / strength", "with p = P/(2Rα)"});
  for (const double degrees : {2., 5., 10., 15., 20., 30.}) {
    const double alpha = degrees / 2 * pi / 180;
    const double ratio = arc_loaded_disc_stress(lines, alpha, 0, 0)[0] / strength;
    table.row({number(degrees, "%.0f"), number(2 * R * std::sin(alpha), "%.2f"),
               number(ratio, "%.4f"), number(ratio * std::sin(alpha) / alpha, "%.4f")});
  }
  std::cout << table.markdown();
  write_file(run.out / "arcs.md", table.markdown());
  results.add("arc_of_contact", 2 * b / R * 180 / pi, "degree");
}

// 2. The loaded diameter under arcs of the contact's second moment, and of its width.
void near_the_load(Results& results) {
  // [moment]
  const double narrower = std::sqrt(0.75) * b / R;  // the second moment of an ellipse on 2 b
  double apart = 0;
  for (double depth = 2 * b; depth < R; depth += 0.1)
    apart = std::max(apart, std::abs(arc_loaded_disc_stress(lines, narrower, 0, depth - R)[0] -
                                     exact_across(depth)));
  // [moment]
  results.add("arc_of_equal_moment", 100 * apart / strength, "%");
  results.add("arc_as_wide_at_2b",
              100 * (arc_loaded_disc_stress(lines, b / R, 0, 2 * b - R)[0] - exact_across(2 * b)) /
                  strength,
              "%");
  results.add("arc_middle", arc_loaded_disc_stress(lines, b / R, 0, 0)[0], "MPa");
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch12_arcs");
  compare_arcs(run, results);
  near_the_load(results);
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch12_arcs", "Arcs of uniform pressure", SIGNORINI_CHAPTER_OUT,
                                argc, argv, chapter);
}

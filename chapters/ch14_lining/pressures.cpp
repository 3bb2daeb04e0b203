// Chapter 14 - What one nodal force says of the pressure, and how that converges.
// Run:  make ch14     Reads: nothing     Writes: ch14_pressures.results, refined.md
#include <cmath>
#include <iostream>

#include "readings.hpp"
#include "rings.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;
using namespace ch14;

// Meshes that are twice as fine, again and again.
void refine(const ProgramOptions& run, Results& results) {
  const double u_exact = inner_rim(closed_form(paper));
  const double p_exact = nested_pressure(closed_form(paper)).inner.outside;
  Table table({"cells per ring", "by the arc", "by the chords", "on the chords", "u(a)"});
  // [refine]
  for (const Index times : {1, 2, 4, 8}) {
    Rings rings;
    rings.cells_angle *= times;
    rings.cells_radius *= times;
    const SolvedScene mortar = run_of(rings);
    rings.gap_operator = "node_to_segment";
    const double half_cell = quarter_turn / 2 / double(rings.cells_angle);
    const double chords = run_of(rings).solution.pressure.mean() * std::cos(half_cell);
    const double arc = chords * std::sin(half_cell) / half_cell;
    // [refine]
    table.row({text(rings.cells_angle, " x ", rings.cells_radius),
               number(percent(arc, p_exact), "%.4f"), number(percent(chords, p_exact), "%.4f"),
               number(percent(mortar.solution.pressure.mean(), p_exact), "%.5f"),
               number(percent(inner_rim(mortar).mean(), u_exact), "%.5f")});
    if (times == 1) results.add("p_by_arc", arc, "MPa");
    if (times == 1) results.add("p_by_chords", chords, "MPa");
  }
  std::cout << table.markdown();
  write_file(run.out / "refined.md", table.markdown());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch14_pressures");
  refine(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch14_pressures", "One force, three pressures", SIGNORINI_CHAPTER_OUT, argc,
                     argv, chapter);
}

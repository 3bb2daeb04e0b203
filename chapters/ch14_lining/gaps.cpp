// Chapter 14 - Two rings without a gap, and with less than none.
// Run:  make ch14     Reads: nothing     Writes: ch14_gaps.results
#include "rings.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/report/shown.hpp"

namespace {

using namespace signorini;
using namespace ch14;

// Rings that touch from the start, and a lining that is too large for its hole.
void other_gaps(Results& results) {
  Rings none;
  none.radii = {60, 68, 68, 76};
  const Scene scene = scene_of(none);
  const SolvedScene two = shown(scene, "rings without gap");
  Rings fit;
  fit.radii = {60, 68.05, 68, 76};
  fit.pressure = 0;
  const SolvedScene pressed = run_of(fit);
  results.add("p_no_gap", two.solution.pressure.mean(), "MPa");
  results.add("p_no_gap_exact", nested_pressure(closed_form(none)).inner.outside, "MPa");
  const NestedRings exact = closed_form(fit);
  const NestedPressure on = nested_pressure(exact);
  results.add("p_fit", pressed.solution.pressure.mean(), "MPa");
  results.add("p_fit_exact", on.inner.outside, "MPa");
  results.add("hoop_fit_lining", ring_stress(exact.inner, on.inner, 60).hoop, "MPa");
  results.add("hoop_fit_rock", ring_stress(exact.outer, on.outer, 68).hoop, "MPa");
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch14_gaps");
  other_gaps(results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch14_gaps", "No gap, and less than none", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}

// Chapter 15 - Friction remembers: a spring slider goes round its loop, by hand, by the library, and without memory.
// Run:  make ch15     Reads: nothing     Writes: ch15.results, fig_15_1.csv
#include <vector>

#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "slider.hpp"

namespace {

using namespace ch15;

// Goes to and fro once, in 20 steps.
void spring(const ProgramOptions& run, Results& results) {
  const Scene scene = triangle(equal_steps(20, 5));
  std::vector<double> forgets;
  forget(scene, [&](const Model&, const Step& alone) {
    forgets.push_back(-alone.solution.contact.friction(0));
  });
  Table table({"time", "hand", "pull", "slip", "by_hand", "forgets"});
  table.row({0., 0., 0., 0., 0., 0.});  // at rest
  // [loop]
  Tip tip;
  WorkMeter meter;
  Work first;  // until time 1, where the loop begins
  remember(scene, [&](const Model& model, const Step& step) {
    const double time = step.state.time, hand = to_and_fro().at(time);
    const double pull = -step.solution.contact.friction(0);
    meter.add(model, step);
    if (time == 1) first = meter.work();
    const auto row = static_cast<std::size_t>(step.state.steps - 1);
    table.row({time, hand, pull, step.state.slip(0), drag(hand, tip), forgets[row]});
  });
  const double area = meter.work().supports - first.supports;        // under the pull of the hand
  const double lost = meter.work().dissipation - first.dissipation;  // |friction| |slip|
  // [loop]
  results.add("loop_area", area, "Nmm");
  results.add("loop_lost", lost, "Nmm");
  results.add("loop_exact", 4 * B * (U - B / k), "Nmm");
  results.headline("loop_area", 4 * B * (U - B / k), "4 B (U - B/k)");
  write_file(run.out / "fig_15_1.csv", table.csv());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch15");
  spring(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch15", "Friction remembers", SIGNORINI_CHAPTER_OUT, argc, argv,
                                chapter);
}

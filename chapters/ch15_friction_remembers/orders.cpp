// Chapter 15 - One end of the loads, in three orders.
// Run:  make ch15     Reads: nothing     Writes: ch15_orders.results, fig_15_4.csv
#include "orders.hpp"

#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch15;

// Shear and push in the end of every order.
void three_orders(const ProgramOptions& run, Results& results) {
  Table figure({"order", "x", "shear", "bound"});
  int place = 0;
  for (const Order& order : orders()) {
    const int steps = place == 2 ? 64 : 8;  // the straight way needs more, see steps.cpp
    const Scene scene = cylinder(equal_steps(steps, 2), order.press, order.push);
    const double push = end_of(scene, &figure, order.name).push;
    const bool none = order.push.times[0] < order.press.times[0];  // nothing but rounding
    results.add(text("push_", place++), push, "-", none ? Repeats::No : Repeats::Yes);
  }
  write_file(run.out / "fig_15_4.csv", figure.csv("rel 1e-5 abs 1e-5"));
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch15_orders");
  three_orders(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch15_orders", "One end, three orders", SIGNORINI_CHAPTER_OUT, argc,
                                argv, chapter);
}

// Chapter 15 - More steps: what they change and what they do not.
// Run:  make ch15     Reads: nothing     Writes: ch15_steps.results, steps.md
#include <iostream>
#include <vector>

#include "orders.hpp"
#include "partial_slip.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch15;

// The push of figure 15.2 and the straight way of figure 15.4, in more and more steps.
void more_steps(const ProgramOptions& run, Results& results) {
  const Pressed known = pressed_cylinder();
  Table table({"steps", "shear on the way back at Q = 0 misses by [%]", "lost in a loop [μJ]",
               "work of the push [μJ]", "Q / μP, straight"});
  for (const int n : {1, 2, 4, 8, 16}) {
    WorkMeter meter;
    Work first;
    double missed = 0;
    remember(by_force(cylinder(push_times(n), pressing, known.push())),
             [&](const Model& model, const Step& step) {
               meter.add(model, step);
               if (step.state.time == 2) first = meter.work();
               if (step.state.time == 3) missed = miss(known, 3, model, step);
             });
    const Order straight = orders()[2];
    const double push = end_of(cylinder(equal_steps(n, 2), straight.press, straight.push)).push;
    const double lost = meter.work().dissipation - first.dissipation;
    const double area = meter.work().put_in() - first.put_in();
    table.row({text(n), number(100 * missed, "%.3f"), number(1e3 * lost, "%.3f"),
               number(1e3 * area, "%.3f"), number(push, "%.4f")});
    results.add(text("lost_", n), 1e3 * lost, "uJ");
    results.add(text("straight_", n), push, "-");
  }
  std::cout << table.markdown();
  write_file(run.out / "steps.md", table.markdown());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch15_steps");
  more_steps(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch15_steps", "How many steps", SIGNORINI_CHAPTER_OUT, argc, argv,
                                chapter);
}

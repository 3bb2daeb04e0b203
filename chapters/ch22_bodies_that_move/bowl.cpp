// Chapter 22 - Why the frozen loop has its rate: stiffness of geometry over stiffness of matter.
// Run:  make ch22     Reads: nothing     Writes: ch22_bowl.results, bowl.md, fig_22_3.csv
#include "bowl.hpp"

#include <cmath>
#include <iostream>

#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;
using namespace ch22;

const int most = 100;
const double arrived = 1e-12;  // beside the size of the bowl [mm]

// Where the loop ends that lets the normal turn.
Node bottom(double weight) {
  Node node{{0, 0}, 0};
  for (int k = 0; k < most; ++k) node = next(node, weight, true);
  return node;
}

// Distances from the end, iteration by iteration.
std::vector<double> errors(double weight, bool turns) {
  const Node end = bottom(weight);
  std::vector<double> all;
  Node node{{0, 0}, 0};
  for (int k = 0; k < most; ++k) {
    node = next(node, weight, turns);
    all.push_back((node.u - end.u).norm());
  }
  return all;
}

// By which factor the last iteration shrinks an error that is not rounding yet.
double last_rate(const std::vector<double>& errors) {
  std::size_t k = errors.size() - 1;
  while (errors[k] < 1e-9) --k;
  return errors[k] / errors[k - 1];
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch22_bowl");
  Table curve({"weight", "turns", "iteration", "error"});
  Table table({"weight [N]", "force / (radius · stiffness)", "rate of the frozen loop"});
  for (const double weight : {0.1, 0.5, 1.0, 1.5}) {
    const std::vector<double> frozen = errors(weight, false);
    for (const bool turns : {false, true}) {
      const std::vector<double> all = errors(weight, turns);
      for (std::size_t k = 0; k < 20 && (k == 0 || all[k - 1] > arrived); ++k)
        curve.row({weight, turns ? 1.0 : 0.0, double(k + 1), std::max(all[k], arrived)});
      curve.blank_line();
    }
    const double ratio = bottom(weight).force / (radius * stiffness);
    const double rate = last_rate(frozen);
    table.row({number(weight), number(ratio, "%.3f"), number(rate, "%.3f")});
    results.add(text("bowl_ratio_", number(10 * weight)), ratio, "-");
    results.add(text("bowl_rate_", number(10 * weight)), rate, "-");
  }
  std::cout << table.markdown();
  write_file(run.out / "bowl.md", table.markdown());
  write_file(run.out / "fig_22_3.csv", curve.csv("rel 1e-4 abs 1e-12"));
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch22_bowl", "A node in a bowl", SIGNORINI_CHAPTER_OUT, argc, argv,
                                chapter);
}

// Chapter 7 - Is linear theory good enough? Two gaps that agree to first order, and a small load.
// Run:  make ch07     Reads: nothing     Writes: ch07_linearity.results
#include "pin.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch07;

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch07_linearity");
  for (const auto& [name, pin] : {std::pair("t", tension), std::pair("c", compression)})
    for (const bool linear : {true, false}) {
      const Bearing now = on_even_mesh({pin.q, pin.clearance, linear}, 72, 36);
      results.add(text(linear ? "linear_gap_" : "distance_", name), now.pressure.maxCoeff(),
                  "kN/cm^2");
    }
  // [small]
  const VectorXd whole = on_even_mesh(tension, 36, 18).pressure;
  const VectorXd part = on_even_mesh({tension.q / 25, tension.clearance / 25}, 36, 18).pressure;
  const double deviation = (25 * part - whole).norm() / whole.norm();
  // [small]
  results.add("small_deviation", deviation, "-", Repeats::No);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch07_linearity", "Is linear theory good enough?", SIGNORINI_CHAPTER_OUT, argc,
                     argv, chapter);
}

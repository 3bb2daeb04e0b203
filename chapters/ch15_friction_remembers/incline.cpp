// Chapter 15 - The steepest incline that holds a block.
// Run:  make ch15     Reads: nothing     Writes: ch15_incline.results
#include <cmath>
#include <string>

#include "blocks.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch15;

// Bisection between what holds and what is refused, against the closed form.
void limits(Results& results) {
  const double degree = pi / 180;
  for (const Friction& law : {Friction{0.4, 0}, Friction{0.4, 0.1}}) {
    const std::string name = law.cohesion > 0 ? "cohesive" : "coulomb";
    const double angle = slip_angle(law);
    results.add("angle_" + name, angle / degree, "deg");
    results.add("error_" + name, std::abs(angle / slip_angle_exact(law) - 1), "-", Repeats::No);
  }
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch15_incline");
  limits(results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch15_incline", "A block on an incline", SIGNORINI_CHAPTER_OUT,
                                argc, argv, chapter);
}

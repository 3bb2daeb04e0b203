// Chapter 13 - A stiffer and stiffer footing against the one that cannot deform, on the same soil.
// Run:  make ch13     Reads: nothing     Writes: ch13_rigid.results
#include <cmath>

#include "base.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch13;

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch13_rigid");
  const Base rigid = rigid_base(coarse);
  for (int power = 0; power <= 12; power += 3) {
    FootingSpec spec;
    spec.modulus = soil_modulus * std::pow(10, power);
    const SolvedScene now = settle(coarse, spec);
    const double off = (base_of(now).force - rigid.force).norm() / rigid.force.norm();
    results.add(text("stiff_", power), off, "-", power < 9 ? Repeats::Yes : Repeats::No);
  }
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch13_rigid", "Rigid from the start", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}

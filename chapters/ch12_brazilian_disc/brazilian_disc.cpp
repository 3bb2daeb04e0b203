// Chapter 12 - The Brazilian disc: the tension in the middle (Lin et al., sec. 3.2, equations (44) and (45)).
// Run:  make ch12     Reads: nothing     Writes: ch12.results
#include <cmath>

#include "reading.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch12;

// 1. Data and scene are in scene.hpp. The field (45) of two line loads: compression along the load, and what a plus
//    between the terms of the shear would give halfway from the middle to the rim.
void line_loads(Results& results) {
  results.add("lines_along", line_loaded_disc_stress(lines, 0, 0)[1], "MPa");
  const double distance = std::hypot(R, R / 2), sine = R / 2 / distance, cosine = R / distance;
  results.add("shear_with_plus", 4 * P / pi * sine * cosine * cosine / distance, "MPa");
}

// 2. The middle of the disc, where (44) is read: from the mesh, from the disc between plates, from (44).
void strength_test(const SolvedScene& now, Results& results) {
  const Eigen::Vector3d stress = middle(now);
  results.add("strength", strength, "MPa");
  results.add("strength_with_3_14", 2 * P / (3.14 * 2 * R), "MPa");
  results.add("middle", stress[0], "MPa");
  results.add("middle_plates", exact_across(R), "MPa");
  results.add("middle_plates_error", 100 * (stress[0] / exact_across(R) - 1), "%");
  results.add("middle_lines_error", 100 * (stress[0] / strength - 1), "%");
  results.add("plates_against_lines", 100 * (exact_across(R) / strength - 1), "%");
  results.add("middle_nodes", static_cast<double>(nodes_of(now)), "-");
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch12");
  line_loads(results);
  strength_test(solve_disc(for_middle), results);
  results.headline("middle", exact_across(R), "disc between plates under the pressure of Hertz");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch12", "The Brazilian disc", SIGNORINI_CHAPTER_OUT, argc, argv,
                                chapter);
}

// Chapter 11 - Plates of other sizes, and the roles of two bodies of which one is hard.
// Run:  make ch11     Reads: nothing     Writes: ch11_other_bodies.results, plates.md, normals.md
#include <iostream>

#include "hertz_run.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;

// 1. How far both bodies sink is a matter of the plate; the contact is not.
void plates(const ProgramOptions& run, Results& results) {
  Table table({"half width [mm]", "depth [mm]", "sinks by [mm]", "q0 [%]", "b [%]"});
  for (const auto& [width, depth] : {std::pair(95, 95), {190, 95}, {95, 190}, {190, 190}}) {
    HertzCase now;
    now.mesh.plate = {width, depth};
    const HertzRun out = solve_hertz(now);
    results.add(text("sinks_", width, "_", depth), sinking(out.run, 1), "mm");
    table.row({std::to_string(width), std::to_string(depth), number(sinking(out.run, 1), "%.4f"),
               percent(out.q_error), percent(out.b_error)});
  }
  std::cout << table.markdown();
  write_file(run.out / "plates.md", table.markdown());
}

// 2. What normals along the radii of the disc do to the half-width, in percent of b: formula (c).
double radial_normals(const HertzCase& now) {
  const double drift =
      (1 - 2 * now.ratio) * (1 + now.ratio) * (1 / now.plate_modulus - 1 / now.disc_modulus);
  return 100 * 4 / (3 * pi) * drift * hertz_peak_pressure(now.theory());
}

void normals(const ProgramOptions& run, Results& results) {
  Table table({"disc, E [MPa]", "plate, E [MPa]", "disc is source [%]", "plate is source [%]",
               "difference", "(c)"});
  const double b = hertz_half_width(HertzCase{}.theory());
  for (const auto& [disc, plate] : {std::pair(4e3, 4e3), {4e3, 4e9}, {4e9, 4e3}}) {
    HertzCase now;
    now.disc_modulus = disc;
    now.plate_modulus = plate;
    now.mesh.core *= hertz_half_width(now.theory()) / b;
    const double flat = solve_hertz(now).b_error;
    now.plate_is_source = true;
    const double round = solve_hertz(now).b_error;
    const std::string bodies = disc == plate ? "alike" : disc < plate ? "hard_plate" : "hard_disc";
    results.add("normals_" + bodies, round - flat, "%");
    results.add("formula_" + bodies, radial_normals(now), "%");
    table.row({number(disc, "%.0e"), number(plate, "%.0e"), percent(flat), percent(round),
               percent(round - flat), percent(radial_normals(now))});
  }
  std::cout << table.markdown();
  write_file(run.out / "normals.md", table.markdown());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch11_other_bodies");
  plates(run, results);
  normals(run, results);
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch11_other_bodies", "Other bodies", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}

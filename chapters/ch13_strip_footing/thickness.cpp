// Chapter 13 - How thick the footing must be to count as rigid.
// Run:  make ch13     Reads: nothing     Writes: ch13_thickness.results, thickness.md, plate.md, fig_13_4_*.csv
#include <cmath>
#include <iostream>

#include "base.hpp"
#include "closed_form/moduli.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch13;

// How thick the footing must be to count as rigid: against a rigid one on the same mesh, and a plate.
void thickness(const ProgramOptions& run, Results& results) {
  const EdgeBlockSpec soil = soil_of(24, 26, 28, 64, 60);
  const double rigid = rigid_base(soil).pressure()(0);
  const double modulus = plane_strain_modulus(soil_modulus, poisson_ratio);
  const double plate = plane_strain_modulus(footing_modulus, poisson_ratio) / 12;  // D = plate t^3
  Table table({"t [m]", "softness ρ", "p(0) over rigid [%]"});
  Table theory({"ρ", "t [m]", "plate, p(0)/q", "body, p(0)/q"});
  Table curve({"thickness", "pressure"}), points({"thickness", "pressure"});
  const auto middle = [&](double t) { return base_of(settle(soil, {t, 10})).pressure()(0); };
  for (const double t : {0.15, 0.2, 0.25, 0.35, 0.5, 0.7, 1.0, 1.5, 2.0}) {
    const double more = middle(t) / rigid - 1;
    curve.row({t, 100 * more});
    if (t != 0.25 && t != 0.5 && t != 1 && t != 2) continue;
    table.row({number(t), number(modulus * std::pow(a / t, 3) / plate, "%.3f"), percent(more)});
    results.add(text("thickness_", t), 100 * more, "%");
  }
  for (const FlexibleStrip& plate_on_soil : flexible_strips) {
    if (plate_on_soil.softness == 0) continue;
    const double t = a * std::cbrt(modulus / plate / plate_on_soil.softness), body = middle(t) / q;
    theory.row({number(plate_on_soil.softness), number(t, "%.3f"),
                number(plate_on_soil.pressure, "%.4f"), number(body, "%.4f")});
    points.row({t, 100 * (plate_on_soil.pressure * q / mean_pressure - 1)});
    results.add(text("plate_", plate_on_soil.softness), 100 * (body / plate_on_soil.pressure - 1),
                "%");
  }
  std::cout << table.markdown();
  write_file(run.out / "thickness.md", table.markdown());
  write_file(run.out / "plate.md", theory.markdown());
  write_file(run.out / "fig_13_4_thickness.csv", curve.csv());
  write_file(run.out / "fig_13_4_plate.csv", points.csv());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch13_thickness");
  thickness(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch13_thickness", "How much footing", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}

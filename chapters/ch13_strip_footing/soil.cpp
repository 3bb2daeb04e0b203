// Chapter 13 - How wide and deep the soil must be.
// Run:  make ch13     Reads: nothing     Writes: ch13_soil.results, domain.md, fig_13_4.csv
#include <cmath>
#include <iostream>

#include "base.hpp"
#include "closed_form/moduli.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch13;

// How wide and deep the soil must be.
void domain(const ProgramOptions& run, Results& results) {
  Table table(
      {"W = H", "p(0) / (2q/π) − 1 [%]", "0.65 (a/H)² [%]", "settlement [mm]", "more [mm]"});
  Table curve({"size", "pressure"});
  double before = 0;
  for (const int size : {3, 5, 10, 20, 40}) {
    const Base base = rigid_base(soil_of(40, 40, 44, 16, size * a));
    const double off = base.deviation()(0), sinks = 1000 * base.settlement;
    table.row({text(size, " a"), percent(off), percent(0.65 / (size * size)), number(sinks, "%.2f"),
               size < 10 ? "" : number(sinks - before, "%.2f")});
    curve.row({1.0 * size, 100 * off});
    results.add(text("middle_", size), 1 + off, "-");
    results.add(text("settlement_", size), sinks, "mm");
    before = sinks;
  }
  const double modulus = plane_strain_modulus(soil_modulus, poisson_ratio);
  results.add("per_doubling", 1000 * 2 * strip.force / (pi * modulus) * std::log(2), "mm");
  std::cout << table.markdown();
  write_file(run.out / "domain.md", table.markdown());
  write_file(run.out / "fig_13_4.csv", curve.csv());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch13_soil");
  domain(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch13_soil", "How much soil", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}

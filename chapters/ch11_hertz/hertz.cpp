// Chapter 11 - Hertz: an elastic cylinder on an elastic plate (Lin et al., sec. 3.1, eq. 43).
// Run:  make ch11     Reads: nothing     Writes: ch11.results, table2.md, fig_11_2.csv, fig_11_2_nodes.csv
#include <iostream>

#include "hertz_run.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/scene/bodies.hpp"

namespace {

using namespace signorini;

const HertzCase example;
const double b = hertz_half_width(example.theory());
const double q0 = hertz_peak_pressure(example.theory());

// Half-width [mm] and largest pressure [MPa] that table 2 prints.
struct Printed {
  double width, peak;
};
constexpr Printed closed_form = {1.08, 24.6219}, paper = {1.09957, 23.8437},
                  abaqus = {1.1178, 23.4287};

// 1. The closed form, and what 3.14 for pi makes of it.
void theory(Results& results) {
  results.add("b", b, "mm");
  results.add("q0", q0, "MPa");
  results.add("q0_with_3_14", q0 * std::sqrt(pi / 3.14), "MPa");
  results.add("b_with_3_14", b * std::sqrt(pi / 3.14), "mm");
  results.add("modulus", example.theory().modulus, "MPa");
}

// 2. Table 2 again: every row with the load that an ellipse of its b and q0 carries.
Table second_table(const HertzRun& ours) {
  Table table({"", "b [mm]", "error [%]", "q0 [MPa]", "error [%]", "πbq0/2 [N/mm]", "error [%]"});
  const auto row = [&](const std::string& name, const Printed& now) {
    const double load = pi * now.width * now.peak / 2;
    table.row({name, number(now.width, "%.5f"), percent(100 * (now.width / b - 1)),
               number(now.peak, "%.4f"), percent(100 * (now.peak / q0 - 1)), number(load, "%.2f"),
               percent(100 * (load / example.load - 1))});
  };
  row("(43)", {b, q0});
  row("(43) as printed", closed_form);
  row("this chapter", {ours.half_width, ours.fit.peak_pressure});
  row("the paper", paper);
  row("its ABAQUS", abaqus);
  return table;
}

// 3. The pressures of the nodes beside the ellipses of the table.
void draw(const std::filesystem::path& folder, const HertzRun& ours) {
  Table ellipses({"x", "theory", "paper", "abaqus"});
  const auto ellipse = [](double x, const Printed& of) {
    return x < of.width ? of.peak * std::sqrt(1 - x * x / (of.width * of.width)) : 0;
  };
  for (int k = 0; k <= 260; ++k) {
    const double x = 0.005 * k;
    ellipses.row({x, hertz_pressure(example.theory(), x), ellipse(x, paper), ellipse(x, abaqus)});
  }
  write_file(folder / "fig_11_2.csv", ellipses.csv());
  write_file(folder / "fig_11_2_nodes.csv", nodal_pressures(ours));
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch11");
  theory(results);
  const HertzRun ours = solve_hertz(example);
  const Table table = second_table(ours);
  std::cout << table.markdown();
  write_file(run.out / "table2.md", table.markdown());
  results.add("q_fit_error", ours.q_error, "%");
  results.add("b_m2_error", ours.b_error, "%");
  results.add("nodes", static_cast<double>(count_nodes(ours.run.model.bodies)), "-");
  const double half = std::accumulate(ours.force.begin(), ours.force.end(), 0.0);
  results.add("resultant", 2 * half, "N/mm");
  results.add("sinks", sinking(ours.run, 1), "mm");
  draw(run.out, ours);
  results.headline("b_m2_error", 0, "closed form, half-planes");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch11", "Hertz: an elastic cylinder on an elastic plate",
                     SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}

// Chapter 12 - Every cut of the disc carries P, and the two contacts are alike.
// Run:  make ch12     Reads: nothing     Writes: ch12_contacts.results, cuts.md, ch12.vtu, fig_12_4.csv, fig_12_4_nodes.csv
#include <iostream>

#include "addons/vtu/vtu.hpp"
#include "closed_form/hertz_fit.hpp"
#include "reading.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch12;

// 1. Cuts along cell sides.
void balance(const ProgramOptions& run, const SolvedScene& now) {
  Table table({"cut at y [mm]", "half of the force [N/mm]"});
  for (const double height : {1.5, 5., 25., 50.1, 75., 98.})
    table.row({number(height, "%.1f"), number(force_across(now, height), "%.6f")});
  std::cout << table.markdown();
  write_file(run.out / "cuts.md", table.markdown());
}

// 2. The two contacts are alike, and nearly those of Hertz.
void contacts(const ProgramOptions& run, const SolvedScene& now, Results& results) {
  const Contact low = contact_of(now, false), high = contact_of(now, true);
  Table nodes({"x", "lower", "upper"});
  Table curve({"x", "hertz"});
  double difference = 0;
  for (std::size_t k = 0; k < low.x.size(); ++k) {
    difference = std::max(difference, std::abs(low.pressure[k] - high.pressure[k]));
    if (low.x[k] < 1.3) nodes.row({low.x[k], low.pressure[k], high.pressure[k]});
  }
  for (int k = 0; k <= 500; ++k) curve.row({0.0025 * k, hertz_pressure(plate, 0.0025 * k)});
  write_file(run.out / "fig_12_4_nodes.csv", nodes.csv("rel 1e-6 abs 1e-6"));
  write_file(run.out / "fig_12_4.csv", curve.csv());
  const double q0 = hertz_peak_pressure(plate);
  results.add("half_width", b, "mm");
  results.add("peak_pressure", q0, "MPa");
  results.add("contact_difference", 100 * difference / q0, "%");
  results.add("lower_peak_error", 100 * (fit_hertz(low.x, low.pressure).peak_pressure / q0 - 1),
              "%");
  results.add("upper_peak_error", 100 * (fit_hertz(high.x, high.pressure).peak_pressure / q0 - 1),
              "%");
  results.add("lower_width_error", 100 * (half_width_of_forces(low.x, low.force) / b - 1), "%");
  results.add("upper_width_error", 100 * (half_width_of_forces(high.x, high.force) / b - 1), "%");
  results.add("iterations", static_cast<double>(now.solution.contact.report.iterations), "-");
  results.add("pairs", static_cast<double>(now.model.pairs.weight.size()), "-");
  results.add("closed_pairs", static_cast<double>(now.solution.contact.active().size()), "-");
  results.add("sinks", -now.solution.displacements[2].col(1).maxCoeff(), "mm");
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch12_contacts");
  const SolvedScene now = solve_disc(for_axis);
  balance(run, now);
  contacts(run, now, results);
  write_vtu(run.out / "ch12.vtu", now.model, now.solution);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch12_contacts", "Cuts and contacts", SIGNORINI_CHAPTER_OUT, argc,
                                argv, chapter);
}

// Chapter 11 - Residuals of the printed method after each step, and the pressures that it finds.
// Run:  make ch11     Reads: nothing     Writes: fig_11_3.csv, fig_11_3_chance.csv, fig_11_4.csv
#include "as_printed.hpp"
#include "hertz_run.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/solvers/fischer_burmeister.hpp"

namespace {

using namespace signorini;

const LineContact theory = HertzCase{}.theory();
const double q0 = hertz_peak_pressure(theory);

void add_residuals(Table& table, const std::vector<double>& values) {
  for (std::size_t k = 0; k < values.size(); ++k) table.row({static_cast<double>(k), values[k]});
  table.blank_line();
}

void add_pressures(Table& table, const PrintedRun& run) {
  std::vector<std::pair<double, double>> at;
  for (Eigen::Index i = 0; i < run.pressure.size(); ++i)
    if (run.model.pairs.position(i, 0) < 1.3)
      at.emplace_back(run.model.pairs.position(i, 0), run.pressure(i) / q0);
  std::sort(at.begin(), at.end());
  for (const auto& [x, p] : at) table.row({x, p});
  table.blank_line();
}

// 1. The residuals of the condensed method, of which the certificate is the last.
std::vector<double> residuals_of(const SolvedScene& run) {
  const double start = run.model.programme.load.norm();
  std::vector<double> residuals = {start};
  for (const Iteration& step : run.solution.contact.report.history)
    residuals.push_back(start * step.residual);
  residuals.push_back(start * std::max(1e-16, run.solution.certificate.worst()));
  return residuals;
}

SolveStatus chapter(const ProgramOptions& run) {
  Table residuals({"step", "residual"}), chance({"step", "residual"}), pressures({"x", "p"});
  // 2. Gauss points: J as printed and mended where nodes meet, as printed where they do not.
  add_residuals(chance, run_as_printed(example_with(2, true), {}).residuals);
  for (const bool match : {true, false}) {
    const PrintedRun points =
        run_as_printed(example_with(2, match), {1, match ? mending({}) : 0, 30});
    add_residuals(residuals, points.residuals);
    add_pressures(pressures, points);
  }
  // 3. Nodes: uncondensed, condensed, and the paper's last residual.
  add_residuals(residuals, run_as_printed(example_with(0, true), {1, 0, 20}).residuals);
  HertzCase now;
  now.solver = fischer_burmeister();
  const HertzRun nodes = solve_hertz(now);
  add_residuals(residuals, residuals_of(nodes.run));
  residuals.row({16.0, printed_residual});
  for (std::size_t k = 0; nodes.x[k] < 1.3; ++k)
    pressures.row({nodes.x[k], nodes.pressure[k] / q0});
  pressures.blank_line();
  for (int k = 0; k <= 130; ++k) pressures.row({0.01 * k, hertz_pressure(theory, 0.01 * k) / q0});
  write_file(run.out / "fig_11_3.csv", residuals.csv("rel 0.9 abs 1e-10"));
  write_file(run.out / "fig_11_3_chance.csv", chance.csv("rel 1 abs 1e300"));
  write_file(run.out / "fig_11_4.csv", pressures.csv("rel 1e-5 abs 1e-6"));
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch11_residuals", "Residuals of the method of section 2.4",
                     SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}

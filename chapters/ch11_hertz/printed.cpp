// Chapter 11 - The method of section 2.4 run: with pressures at Gauss points, and at nodes.
// Run:  make ch11     Reads: nothing     Writes: ch11_printed.results, printed.md
#include <iostream>

#include "as_printed.hpp"
#include "hertz_run.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/solvers/fischer_burmeister.hpp"

namespace {

using namespace signorini;
using Eigen::Index;

const LineContact theory = HertzCase{}.theory();
const double b = hertz_half_width(theory);
const double q0 = hertz_peak_pressure(theory);

// 1. Closed pairs at the end, and how many combinations of their pressures the nodes feel: the rank of their rows of A.
std::pair<Index, Index> closed_and_independent(const PrintedRun& run) {
  std::vector<Index> closed;
  for (Index i = 0; i < run.gap.size(); ++i)
    if (run.gap(i) < 1e-10) closed.push_back(i);
  const Eigen::MatrixXd rows = Eigen::MatrixXd(run.model.programme.A)(closed, Eigen::all);
  return {rows.rows(), column_span(rows.transpose(), 1e-10).rank};
}

// 2. Root mean square of the error of the pressures at x < 0.7 b, all of them alike [% of q0].
double rms_error(const PrintedRun& run) {
  double sum = 0, count = 0;
  for (Index i = 0; i < run.pressure.size(); ++i) {
    const double x = run.model.pairs.position(i, 0);
    if (x >= 0.7 * b) continue;
    sum += std::pow(run.pressure(i) - hertz_pressure(theory, x), 2);
    ++count;
  }
  return 100 * std::sqrt(sum / count) / q0;
}

// 3. Nodes meet and J is not mended: it is singular at the solution, and rounding decides.
std::vector<std::string> by_chance(Results& results) {
  HertzCase now = example_with(2, true);
  results.add("steps_chance", run_as_printed(now, {}).steps(), "-", Repeats::No);
  now.load *= 1 + 1e-12;
  results.add("steps_chance_other", run_as_printed(now, {}).steps(), "-", Repeats::No);
  return {"Gauss points", "match", "not mended", "", "", "by chance", "by chance", "", ""};
}

// 4. A row of a run that converges, in MPa and mm and scaled.
std::vector<std::string> converged(Results& results, const std::string& key, int points, bool match,
                                   double yielding) {
  const HertzCase now = example_with(points, match);
  const PrintedRun mm = run_as_printed(now, {1, yielding, points > 0 ? 30 : 20});
  const PrintedRun scaled =
      run_as_printed(now, {b / theory.modulus, yielding, points > 0 ? 20 : 13});
  const auto& [closed, independent] = closed_and_independent(mm);
  results.add("peak_" + key, mm.pressure.maxCoeff() / q0, "-");
  results.add("peak_" + key + "_scaled", scaled.pressure.maxCoeff() / q0, "-");
  results.add("closed_" + key, static_cast<double>(closed), "-");
  results.add("independent_" + key, static_cast<double>(independent), "-");
  const bool steady = points == 0 || yielding > 0;  // else a J on the way is nearly singular
  results.add("steps_" + key, mm.steps(), "-", steady ? Repeats::Yes : Repeats::No);
  results.add("steps_" + key + "_scaled", scaled.steps(), "-");
  return {points > 0 ? "Gauss points" : "nodes",
          match ? "match" : "do not",
          yielding > 0 ? "mended" : "not mended",
          std::to_string(closed),
          std::to_string(independent),
          steady ? std::to_string(mm.steps()) : text("about ", (mm.steps() + 5) / 10 * 10),
          std::to_string(scaled.steps()),
          number(mm.pressure.maxCoeff() / q0, "%.3f"),
          number(rms_error(mm), "%.2f")};
}

// 5. The condensed method, for comparison.
std::vector<std::string> condensed() {
  HertzCase now;
  now.solver = fischer_burmeister();
  const HertzRun ours = solve_hertz(now);
  const std::string active = std::to_string(ours.run.solution.contact.active().size());
  const double peak = *std::max_element(ours.pressure.begin(), ours.pressure.end());
  return {"nodes",
          "match",
          "condensed",
          active,
          active,
          "",
          std::to_string(ours.run.solution.contact.report.iterations),
          number(peak / q0, "%.3f"),
          number(pressure_error(ours), "%.2f")};
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch11_printed");
  Table table({"pressures at", "meshes", "J", "closed", "independent", "steps, unscaled", "steps, scaled",
               "largest p/q0", "rms p [%]"});
  table.row(by_chance(results));
  table.row(converged(results, "mended", 2, true, mending({})));
  table.row(converged(results, "points", 2, false, 0));
  table.row(converged(results, "nodes", 0, true, 0));
  table.row(converged(results, "nodes_apart", 0, false, 0));
  table.row(condensed());
  std::cout << table.markdown();
  write_file(run.out / "printed.md", table.markdown());
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch11_printed", "The method of section 2.4", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}

// What the estimator is worth: estimated over true error of the goals of eight problems, on four meshes of every element.
// Run:  make effectivity     Reads: nothing     Writes: effectivity and half_width, each as .md and .csv
// Without --full on small meshes: a test of this program and of what it judges, not a measurement.
#include "support/effectivity.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>

#include "bench/measure.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"

namespace {

using namespace signorini;
using namespace signorini::bench;
using namespace signorini_test;
using Eigen::Index;

/// Without --full one mesh of each problem, and truths of twice as many cells.
std::vector<Measured> problems_of(bool full) {
  std::vector<Measured> problems = {measured_cantilever(), measured_push(), measured_hertz(),
                                    measured_footing(), measured_pin()};
  if (full) {
    for (const Measured& problem : measured_with_friction()) problems.push_back(problem);
    return problems;
  }
  for (Measured& problem : problems) {
    problem.cells = {problem.cells[1]};
    problem.fine = 2 * problem.cells[0];
  }
  return problems;
}

void add(Table& table, const std::string& scene, const std::string& element,
         const Measurement& now) {
  const Estimate& one = now.estimate;
  table.row({scene, element, std::to_string(now.nodes), one.goal, number(one.value),
             number(one.error, "%.4g"), number(now.truth), number(now.effectivity(), "%.3f"),
             number(100 * one.error / std::abs(now.truth), "%.4f"),
             number(one.parts.interior, "%.3g"), number(one.parts.gap, "%.3g"),
             number(one.parts.quadrature_error, "%.3g"), number(one.parts.free_boundary, "%.3g")});
}

const std::vector<std::string> columns = {
    "scene",       "element",    "nodes",    "goal", "value",   "estimate",     "truth",
    "effectivity", "estimate %", "interior", "gap",  "reading", "free boundary"};

/// \return whether of every problem without friction three elements hold for every force and displacement on all meshes
bool problems(const ProgramOptions& options, Table& table) {
  bool good = true;
  for (const Measured& problem : problems_of(options.full)) {
    const std::vector<double> truth = truth_of(problem, problem.fine);
    const std::vector<double> coarser = truth_of(problem, 2 * problem.fine / 3);
    double doubt = 0;
    for (std::size_t k = 0; k < truth.size(); ++k)
      doubt = std::max(doubt, std::abs(coarser[k] / truth[k] - 1));
    std::cout << problem.name << ": true values known to about " << number(100 * doubt, "%.1g")
              << " %\n";
    int holds = 0;
    for (const std::string element : {"q4", "q4_bbar", "q4_incompatible", "t3", "q8", "t6"}) {
      bool all = true;
      for (const Index cells : problem.cells)
        for (const Measurement& now :
             measured(problem.scene(element, cells), problem.goals, truth)) {
          add(table, problem.name, element, now);
          if (now.good()) continue;
          all = all && !now.estimate.is_signed;
          std::cout << "  outside: " << element << ", " << now.nodes << " nodes, "
                    << now.estimate.goal << ": " << number(now.effectivity(), "%.2f")
                    << ", true error " << number(100 * (now.truth / now.estimate.value - 1), "%.2g")
                    << " %\n";
        }
      holds += all ? 1 : 0;
    }
    std::cout << "  elements that hold throughout: " << holds << '\n';
    good = good && (holds >= 3 || problem.friction > 0);
  }
  return good;
}

/// \return whether nine in ten half-widths hold, of elements of four nodes
bool half_widths(const ProgramOptions& options, Table& table) {
  const double truth = hertz_half_width(HertzProblem{}.theory());
  const std::vector<Index> cells =
      options.full ? std::vector<Index>{12, 14, 16, 18, 20} : std::vector<Index>{14};
  const std::vector<Goal> width = {{"half-width", HalfWidth{}}};
  bool good = true;
  for (const std::string element : {"q4", "q4_bbar", "q4_incompatible"}) {
    int holds = 0, count = 0;
    for (const HertzMeshSpec& spec : hertz_layouts(cells)) {
      const Measurement now = measured(hertz(spec, element.c_str()), width, {truth}).front();
      add(table, "Hertz", element, now);
      holds += now.good() ? 1 : 0;
      ++count;
    }
    std::cout << "half-width, " << element << ": " << holds << " of " << count << " hold\n";
    good = good && 10 * holds >= 9 * count;
  }
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  const auto body = [](const ProgramOptions& options) {
    std::cout << "Effectivity: estimated over true error; it holds between 0.5 and 2.\n";
    Table table(columns), widths(columns);
    const bool held = problems(options, table);
    write_table(options.out, "effectivity", table);
    const bool wide = half_widths(options, widths);
    write_table(options.out, "half_width", widths);
    std::cout << "\nthree elements hold on every problem without friction: "
              << (held ? "yes" : "NO")
              << "; nine of ten half-widths of each: " << (wide ? "yes" : "NO") << '\n';
    return held ? SolveStatus::Solved : SolveStatus::Breakdown;
  };
  return run_program("effectivity", "What error estimates are worth; --full measures",
                     SIGNORINI_BENCH_OUT, argc, argv, body);
}

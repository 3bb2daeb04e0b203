// What an accuracy costs that is asked for: true errors, and seconds of processor beside the best mesh picked by hand.
// Run:  make accuracy     Reads: nothing     Writes: accuracy.md and accuracy.csv
// Without --full one target only: a test of this program and of what it judges, not a measurement.
#include "signorini/estimate/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <optional>

#include "bench/measure.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/scene/readings.hpp"
#include "support/effectivity.hpp"
#include "support/lining_rings.hpp"

namespace {

using namespace signorini;
using namespace signorini::bench;
using namespace signorini_test;
using Eigen::Index;

/// Meshes that one may pick by hand: of one shape each, and finer and finer.
using Layout = std::function<Scene(Index cells)>;

/// A goal, a mesh to begin with, and what is known of it.
struct Problem {
  std::string name;
  Goal goal;
  Scene start;
  double truth;
  std::vector<Layout> layouts;
  std::vector<Index> cells;  // rising
};

std::vector<Problem> hertz_problems() {
  std::vector<Layout> layouts;
  for (const double core : {1.2, 1.4, 1.7})
    for (const Index rows : {2, 3})
      for (const Index layers : {3, 4, 5})
        layouts.emplace_back([=](Index cells) {
          HertzMeshSpec spec;
          spec.core = core;
          spec.disc_cells = spec.plate_cells = cells;
          spec.disc_rows = spec.plate_rows = rows * cells / 4;
          spec.disc_layers = spec.plate_layers = layers * cells / 4;
          return signorini_test::hertz(spec);
        });
  HertzMeshSpec coarse;
  coarse.core = 5;
  coarse.disc_cells = coarse.plate_cells = 8;
  coarse.disc_rows = coarse.plate_rows = coarse.disc_layers = coarse.plate_layers = 6;
  const Scene start = signorini_test::hertz(coarse);
  const LineContact theory = HertzProblem{}.theory();
  const std::vector<Index> cells = {8, 12, 16, 20, 24, 32, 40, 48};
  return {{"Hertz", {"peak", PeakPressure{}}, start, hertz_peak_pressure(theory), layouts, cells},
          {"Hertz", {"width", HalfWidth{}}, start, hertz_half_width(theory), layouts, cells}};
}

/// Goals of a problem whose truth is that of fine cells of eight nodes.
std::vector<Problem> finely(const Measured& measured, Index start, Index fine,
                            const std::vector<Layout>& layouts, const std::vector<Index>& cells) {
  const SolvedScene run = solved(measured.scene("q8", fine), measured.name);
  std::vector<Problem> problems;
  for (const Goal& goal : measured.goals)
    problems.push_back({measured.name, goal, measured.scene("q4_incompatible", start),
                        value(run.model, run.solution, goal), layouts, cells});
  return problems;
}

std::vector<Problem> footing_problems(bool full) {
  std::vector<Layout> layouts;
  for (const double grading : {4.0, 16.0, 60.0})
    for (const Index deep : {2, 3})
      layouts.emplace_back([=](Index cells) {
        FootingSpec footing;
        footing.rows = cells / 3;
        return footing_on(soil_spec(cells, 4 * cells / 3, deep * cells / 3, grading, 60), footing);
      });
  return finely(measured_footing(), 6, full ? 120 : 48, layouts, {12, 15, 18, 24, 36, 48, 72, 96});
}

std::vector<Problem> pin_problems(bool full) {
  std::vector<Layout> layouts;
  for (const Index radial : {1, 2})
    layouts.emplace_back([=](Index cells) {
      return pin_in_plate(-25, cells, cells / radial, 0.2, "q4_incompatible");
    });
  return finely(measured_pin(), 15, full ? 216 : 72, layouts,
                {12, 18, 24, 36, 48, 72, 96, 144, 192});
}

/// One ring in another, which nothing in the refinement was chosen for: its truth is in closed form.
std::vector<Problem> lining_problems() {
  std::vector<Layout> layouts;
  for (const Index rows : {2, 4, 8})
    layouts.emplace_back([=](Index cells) { return lining_rings(cells, rows); });
  return {{"lining",
           {"force", ContactForce{}},
           lining_rings(9, 5),
           lining_force(),
           layouts,
           {6, 9, 12, 18, 24, 36, 48, 72}}};
}

double error_of(const Problem& problem, double value) {
  return std::abs(value / problem.truth - 1);
}

/// One mesh picked by hand.
struct Picked {
  Index unknowns;
  double error;
  double seconds;  // of processor, the median of three runs
};

Picked picked(const Problem& problem, const Scene& scene) {
  Picked result{};
  std::vector<double> seconds;
  for (int k = 0; k < 3; ++k) {
    const double begin = processor_seconds();
    const SolvedScene run = solved(scene, problem.name);
    seconds.push_back(processor_seconds() - begin);
    result.unknowns = run.model.unknowns.count;
    result.error = error_of(problem, value(run.model, run.solution, problem.goal));
  }
  result.seconds = median(seconds);
  return result;
}

/// The cheapest mesh picked by hand that meets a target, and not by luck: the next finer one of its shape does too.
std::optional<Picked> best_by_hand(const std::vector<std::vector<Picked>>& layouts, double target) {
  std::optional<Picked> best;
  for (const std::vector<Picked>& layout : layouts)
    for (std::size_t k = 0; k + 1 < layout.size(); ++k)
      if (layout[k].error <= target && layout[k + 1].error <= target) {
        if (!best || layout[k].seconds < best->seconds) best = layout[k];
        break;
      }
  return best;
}

/// \return whether all errors are below their targets
bool add(const Problem& problem, const std::vector<double>& targets, bool by_hand, Table& table) {
  std::vector<std::vector<Picked>> layouts;
  for (std::size_t k = 0; by_hand && k < problem.layouts.size(); ++k) {
    layouts.emplace_back();
    for (const Index cells : problem.cells) {
      layouts.back().push_back(picked(problem, problem.layouts[k](cells)));
      const std::size_t n = layouts.back().size();
      if (n > 1 && layouts.back()[n - 2].error <= targets.back() &&
          layouts.back()[n - 1].error <= targets.back())
        break;
    }
  }
  bool good = true;
  for (const double target : targets) {
    const double begin = processor_seconds();
    const AccurateSolution result = solve_to_accuracy(problem.start, {target, problem.goal});
    const double seconds = processor_seconds() - begin;
    const AccuracyRound& last = result.rounds.back();
    const double error = error_of(problem, last.value);
    good = good && result.met && error < target;
    const std::optional<Picked> hand = best_by_hand(layouts, target);
    const auto percent = [](double part) { return number(100 * part, "%.3g"); };
    table.row({problem.name, problem.goal.name, percent(target), result.met ? "yes" : "NO",
               std::to_string(result.rounds.size()), std::to_string(last.unknowns),
               last.error ? percent(*last.error / std::abs(last.value)) : "-", percent(error),
               number(seconds, "%.3f"), hand ? std::to_string(hand->unknowns) : "-",
               hand ? number(hand->seconds, "%.4f") : "-",
               hand ? number(seconds / hand->seconds, "%.1f") : "-"});
    if (!result.met)
      std::cout << problem.name << ", " << problem.goal.name << ": " << result.verdict << '\n';
  }
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  const auto body = [](const ProgramOptions& options) {
    const std::vector<double> targets =
        options.full ? std::vector<double>{0.01, 0.003, 0.001} : std::vector<double>{0.01};
    Table table({"scene", "goal", "target %", "met", "meshes", "unknowns", "estimate %",
                 "true error %", "s", "by hand: unknowns", "by hand: s", "times as long"});
    bool good = true;
    for (const auto& problems : {hertz_problems(), footing_problems(options.full),
                                 pin_problems(options.full), lining_problems()})
      for (const Problem& problem : problems)
        good = add(problem, targets, options.full, table) && good;
    write_table(options.out, "accuracy", table);
    std::cout << "\ntrue errors below the targets: " << (good ? "all" : "NOT ALL") << '\n';
    return good ? Status::Solved : Status::Breakdown;
  };
  return run_program("accuracy", "What accuracy costs that is asked for; --full measures",
                     SIGNORINI_BENCH_OUT, argc, argv, body);
}

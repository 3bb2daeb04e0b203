// What the estimator is worth: estimated over true error of the goals of eight problems, on four meshes of every element.
// Run:  make effectivity     Reads: nothing     Writes: effectivity and half_width, each as .md and .csv
// Without --full on small meshes: a test of this program and of what it judges, not a measurement.
#include "support/effectivity.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <set>

#include "bench/measure.hpp"
#include "signorini/core/table.hpp"
#include "signorini/estimate/estimate.hpp"
#include "signorini/report/program.hpp"
#include "signorini/scene/readings.hpp"

namespace {

using namespace signorini;
using namespace signorini::bench;
using namespace signorini_test;
using Eigen::Index;

/// A problem and the meshes that it is measured on.
struct Study {
  Measured problem;
  std::vector<Index> cells;  // along the contact, rising
  Index fine;                // of the truth, with cells of eight nodes
  double friction = 0;       // coefficient of Coulomb's law

  [[nodiscard]] std::string name() const {
    return friction > 0 ? problem.name + " with friction" : problem.name;
  }
  [[nodiscard]] Scene scene(const std::string& element, Index along) const {
    Scene scene = problem.scene(element, along);
    if (friction > 0) scene.contacts[0].friction = Friction{friction};
    return scene;
  }
};

std::vector<Study> studies(bool full) {
  if (!full)
    return {{measured_cantilever(), {50}, 100},
            {measured_push(), {16}, 32},
            {measured_hertz(), {16}, 32},
            {measured_footing(), {15}, 48},
            {measured_pin(), {48}, 72}};
  return {{measured_cantilever(), {30, 50, 100, 200}, 500},
          {measured_push(), {12, 16, 24, 32}, 64},
          {measured_hertz(), {12, 16, 24, 32}, 64},
          {measured_footing(), {15, 18, 24, 36}, 120},
          {measured_pin(), {24, 48, 72, 96}, 216},
          {measured_cantilever(), {30, 50, 100, 200}, 400, 0.02},
          {measured_footing(), {15, 18, 24, 36}, 120, 0.1},
          {measured_pin(), {24, 48, 72, 96}, 216, 0.2}};
}

/// Values of the goals by cells of eight nodes; half-width and peak of Hertz as in the closed form.
std::vector<double> truth_of(const Study& study, Index cells) {
  const SolvedScene run = solved(study.scene("q8", cells), study.name());
  const LineContact theory = HertzProblem{}.theory();
  std::vector<double> truth;
  for (const Goal& goal : study.problem.goals)
    truth.push_back(std::holds_alternative<HalfWidth>(goal.quantity) ? hertz_half_width(theory)
                    : std::holds_alternative<PeakPressure>(goal.quantity)
                        ? hertz_peak_pressure(theory)
                        : value(run.model, run.solution, goal));
  return truth;
}

/// One goal on one mesh.
struct Measurement {
  Index nodes;
  Estimate estimate;
  double truth;
  double share;  // of the seconds of the solution that all estimates of the problem took

  [[nodiscard]] double effectivity() const {
    const double error = truth - estimate.value;
    return estimate.error / (estimate.is_signed ? error : std::abs(error));
  }
  [[nodiscard]] bool good() const { return effectivity() >= 0.5 && effectivity() <= 2; }
};

std::vector<Measurement> measured(const Scene& scene, const std::vector<Goal>& goals,
                                  const std::vector<double>& truth) {
  const SolvedScene run = solved(scene, "scene");
  Ledger ledger;
  const std::vector<Estimate> all =
      estimates(run.model, run.condensed, run.solution, goals, ledger);
  double seconds = 0;
  for (const LedgerEntry& entry : run.solution.ledger.entries())
    if (entry.path.find('/') == std::string::npos) seconds += entry.seconds;
  Index nodes = 0;
  for (const BodyModel& body : run.model.bodies) nodes += body.mesh.n_nodes();
  std::vector<Measurement> of_goals;
  for (std::size_t k = 0; k < all.size(); ++k)
    of_goals.push_back({nodes, all[k], truth[k], ledger.seconds("estimate") / seconds});
  return of_goals;
}

void add(Table& table, const std::string& scene, const std::string& element,
         const Measurement& now) {
  const Estimate& one = now.estimate;
  table.row({scene, element, std::to_string(now.nodes), one.goal, number(one.value),
             number(one.error, "%.4g"), number(now.truth), number(now.effectivity(), "%.3f"),
             number(100 * one.error / std::abs(now.truth), "%.4f"),
             number(one.parts.interior, "%.3g"), number(one.parts.gap, "%.3g"),
             number(one.parts.reading, "%.3g"), number(one.parts.free_boundary, "%.3g")});
}

const std::vector<std::string> columns = {
    "scene",       "element",    "nodes",    "goal", "value",   "estimate",     "truth",
    "effectivity", "estimate %", "interior", "gap",  "reading", "free boundary"};

/// \return whether of every problem without friction three elements hold for every force and displacement on all meshes
bool problems(const ProgramOptions& options, Table& table) {
  bool good = true;
  for (const Study& study : studies(options.full)) {
    const std::vector<double> truth = truth_of(study, study.fine);
    const std::vector<double> coarser = truth_of(study, 2 * study.fine / 3);
    double doubt = 0;
    for (std::size_t k = 0; k < truth.size(); ++k)
      doubt = std::max(doubt, std::abs(coarser[k] / truth[k] - 1));
    std::cout << study.name() << ": true values known to about " << number(100 * doubt, "%.1g")
              << " %\n";
    int holds = 0;
    for (const std::string element : {"q4", "q4_bbar", "q4_incompatible", "t3", "q8", "t6"}) {
      bool all = true;
      for (const Index cells : study.cells)
        for (const Measurement& now :
             measured(study.scene(element, cells), study.problem.goals, truth)) {
          add(table, study.name(), element, now);
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
    good = good && (holds >= 3 || study.friction > 0);
  }
  return good;
}

/// Hertz's contact on meshes that differ in fineness, in the size of the core and in whether they match.
std::vector<HertzMeshSpec> hertz_layouts(bool full) {
  std::vector<HertzMeshSpec> layouts;
  for (const Index cells : full ? std::vector<Index>{12, 14, 16, 18, 20} : std::vector<Index>{14})
    for (const double core : {1.3, 1.4, 1.5})
      for (const Index more : {0, 3}) {
        if (core == 1.5 && more != 0) continue;
        HertzMeshSpec spec;
        spec.core = core;
        spec.disc_cells = spec.disc_layers = spec.plate_layers = cells;
        spec.plate_cells = cells + more;
        spec.disc_rows = spec.plate_rows = 3 * cells / 4;
        layouts.push_back(spec);
      }
  return layouts;
}

/// \return whether nine in ten half-widths hold, of elements of four nodes
bool half_widths(const ProgramOptions& options, Table& table) {
  const double truth = hertz_half_width(HertzProblem{}.theory());
  const std::vector<Goal> width = {{"half-width", HalfWidth{}}};
  bool good = true;
  for (const std::string element : {"q4", "q4_bbar", "q4_incompatible"}) {
    int holds = 0, count = 0;
    for (const HertzMeshSpec& spec : hertz_layouts(options.full)) {
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
    return held ? Status::Solved : Status::Breakdown;
  };
  return run_program("effectivity", "What error estimates are worth; --full measures",
                     SIGNORINI_BENCH_OUT, argc, argv, body);
}

// Chapter 18 - Only the effects a scene calls for.
// Run:  make ch18     Reads: nothing     Writes: ch18.results, plan.md, ladder.md, refusals.md, fig_18_*.csv
#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>

#include "scenes.hpp"
#include "signorini/closed_form/hertz.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"

namespace {

using namespace signorini;

// 1. What the plan says of a scene: what is on and why, and what is off.
void show_plan(const ProgramOptions& run, const Scene& scene) {
  std::ostringstream said;
  const Plan planned = plan(scene);
  said << planned;
  write_file(run.out / "plan.md", "```text\n" + said.str() + "```\n");
  std::cout << said.str();
  draw(run.out, planned);
}

// 2. The ladder: every rung changes one thing, and with it rows, unknowns, or nothing but numbers.
// [ladder]
void climb(const ProgramOptions& run, Results& results) {
  Table table(
      {"rung", "unknowns", "gaps", "slips", "amplitudes", "work [10⁶]", "largest pressure [MPa]"});
  const auto rung = [&](const std::string& name, const Scene& scene) {
    const SolvedScene now = solved(scene, name);
    const ContactProblem& problem = now.condensed.problem;
    const double q = peak_pressure(now);
    table.row({name, text(now.model.unknowns.count), text(problem.free_gap.size()),
               text(problem.free_slip.size()), text(problem.resultant.size()),
               number(1e-6 * work(now.solution.ledger), "%.0f"), number(q, "%.3f")});
    std::cout << name << '\n' << now.solution.ledger << '\n';
    return q;
  };
  const Scene pushed = on_rock(0.025);
  const Scene free = floating(with_plate(pushed));
  rung("obstacle", pushed);
  rung("two bodies", with_plate(pushed));
  const double smooth = rung("floating", free);
  const double rough = rung("friction", with_friction(free));
  rung("heat", heated(with_friction(free)));
  // [ladder]
  results.add("friction_between_equals", 1e6 * std::abs(rough / smooth - 1), "ppm", Repeats::No);
  write_file(run.out / "ladder.md", table.markdown());
  show_plan(run, heated(with_friction(free)));
}

/// An effect, what its size is told by, and two scenes that differ in it alone.
struct Question {
  std::string effect, measure;
  double estimate;  // of the change of the largest pressure, before anything is computed [%]
  Scene without, with;
};

// 3. What may matter: each number says by how much the largest pressure may change.
// [questions]
std::vector<Question> questions() {
  const Scene base = floating(on_rock(0)), plate = with_plate(base);
  const double b = hertz_half_width({R, stiff / 2, P});  // of the contact with a plate [mm]
  const double nu = resin.poisson_ratio;
  const double beta = (1 - 2 * nu) / (2 - 2 * nu);  // Dundurs' second constant, against rock
  const double weight = specific_weight * pi * R * R / (2 * P);
  return {
      {"a plate of resin", "√(E*/E′) − 1", 100 * (std::sqrt(0.5) - 1), base, plate},
      {"a thin plate", "(b/H)²", 100 * std::pow(b / thin, 2), plate, with_plate(base, thin)},
      {"friction", "μβ or β²", 100 * beta * std::min(friction, beta), base, with_friction(base)},
      {"heat", "−(1+ν)αΔT/2", -50 * thermal, base, heated(base)},
      {"weight", "ρgπR²/4P", 50 * weight, base, with_weight(base)}};
}
// [questions]

// 4. The answers: each effect switched on alone.
void answer(const ProgramOptions& run, Results& results) {
  Table bars({"place", "effect", "measure", "estimate", "computed"});
  double place = 0;
  for (const Question& asked : questions()) {
    const double before = peak_pressure(solved(asked.without, "the scene without it"));
    const double computed = 100 * (peak_pressure(solved(asked.with, asked.effect)) / before - 1);
    bars.row(
        {number(++place), asked.effect, asked.measure, number(asked.estimate), number(computed)});
    results.add("estimate_" + text(place), asked.estimate, "%");
    results.add("size_" + text(place), computed, "%");
  }
  write_file(run.out / "fig_18_2.csv", bars.csv("rel 1e-4 abs 1e-6"));
  // A body that is drawn as large as it will be when it is warm.
  const Scene base = floating(on_rock(0));
  Scene grown = base;
  grown.bodies[0].mesh.nodes *= 1 + thermal;
  grown.bodies[0].loads.edges[0].pressure /= 1 + thermal;  // the same load
  const double before = peak_pressure(solved(base, "the cold cylinder"));
  results.add("heat_drawn", 100 * (peak_pressure(solved(grown, "the drawn one")) / before - 1),
              "%");
}

// 5. What cannot be meant is refused, in words that say the way out.
// [refusals]
void refusals(const ProgramOptions& run) {
  std::string list;
  for (const Mistake& mistake : mistakes()) {
    Scene scene = floating(with_plate(on_rock(0)));
    mistake.make(scene);
    try {
      const Plan planned = plan(scene);
      list += "* " + mistake.what + ", and a note: *" + planned.notes.back() + "*\n";
    } catch (const ProblemError& error) {
      list += "* " + mistake.what + ": *" + error.what() + "*\n";
    }
  }
  write_file(run.out / "refusals.md", list);
}
// [refusals]

Status chapter(const ProgramOptions& run) {
  Results results("ch18");
  climb(run, results);
  answer(run, results);
  refusals(run);
  results.headline("size_1", 100 * (std::sqrt(0.5) - 1), "theory of Hertz");
  results.print();
  results.write(run.out);
  return Status::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch18", "Only the effects a scene calls for", SIGNORINI_CHAPTER_OUT,
                                argc, argv, chapter);
}

// Chapter 18 - Only the effects a scene calls for: a number for each, and what it changes.
// Run:  make ch18     Reads: nothing     Writes: ch18.results, fig_18_2.csv
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "closed_form/hertz.hpp"
#include "scenes.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;

// An effect, the number that tells its size, and two scenes that differ in it alone.
struct Question {
  std::string effect, measure;
  double estimate;  // of the change of the largest pressure, before anything is computed [%]
  Scene without, with;
};

// What may matter: each number says by how much the largest pressure may change.
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

// The answers: each effect switched on alone.
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

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch18");
  answer(run, results);
  results.headline("size_1", 100 * (std::sqrt(0.5) - 1), "theory of Hertz");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch18", "Only the effects a scene calls for", SIGNORINI_CHAPTER_OUT,
                                argc, argv, chapter);
}

// Chapter 15 - Partial slip: the push grows to 0.6 mu P, turns, and turns again; Cattaneo and Mindlin.
// Run:  make ch15     Reads: nothing     Writes: ch15_partial_slip.results, states.md, fig_15_2*.csv
#include "partial_slip.hpp"

#include <algorithm>
#include <iostream>
#include <vector>

#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch15;

// The shear at the times that the text shows, beside the closed form and beside slip in total.
const std::vector<double> shown = {2, 3, 3.5, 4};

// Shear over its largest bound, of a step and in closed form.
void draw(const Pressed& known, const Model& model, const Step& step, Table& found, Table& exact) {
  const double time = step.state.time, bound = mu * known.slip.peak_pressure;
  const Eigen::VectorXd shear = shear_of(model, step);
  for (Index i = 0; i < shear.size(); ++i)
    found.row({time, model.pairs.position(i, 0), shear(i) / bound,
               mu * step.solution.pressure(i) / bound});
  for (int i = -200; i <= 200; ++i) {
    const double x = known.slip.half_width * i / 200;
    exact.row({time, x, known.shear(time, x) / bound});
  }
  found.blank_line();
  exact.blank_line();
}

void partial_slip(const ProgramOptions& run, Results& results) {
  const Pressed known = pressed_cylinder();
  std::vector<double> forgot;
  forget(by_force(cylinder(shown, pressing, known.push())),
         [&](const Model& model, const Step& step) {
           forgot.push_back(100 * miss(known, step.state.time, model, step));
         });
  Table found({"time", "x", "shear", "bound"}), exact({"time", "x", "shear"});
  Table states(
      {"Q / μP", "shear misses by [% of μq₀]", "with slip in total", "the same in closed form"});
  remember(by_force(cylinder(push_times(6), pressing, known.push())), [&](const Model& model,
                                                                          const Step& step) {
    const double time = step.state.time;
    if (time == 2) results.add("stick", stuck_half_width(known, model, step), "mm");
    const auto at = std::find(shown.begin(), shown.end(), time);
    if (at == shown.end()) return;
    const auto row = static_cast<std::size_t>(at - shown.begin());
    draw(known, model, step, found, exact);
    states.row({number(known.push().at(time) / (mu * known.P), "%.1f"),
                number(100 * miss(known, time, model, step), "%.1f"), number(forgot[row], "%.1f"),
                number(100 * forgotten(known, time), "%.1f")});
    results.add(text("forgot_", row), forgot[row], "%");
  });
  std::cout << states.markdown();
  write_file(run.out / "states.md", states.markdown());
  write_file(run.out / "fig_15_2.csv", found.csv("rel 1e-5 abs 1e-6"));
  write_file(run.out / "fig_15_2_exact.csv", exact.csv());
  results.add("b", known.slip.half_width, "mm");
  results.add("stick_exact", stick_half_width(known.slip, known.Q), "mm");
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch15_partial_slip");
  partial_slip(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch15_partial_slip", "Partial slip", SIGNORINI_CHAPTER_OUT, argc,
                                argv, chapter);
}

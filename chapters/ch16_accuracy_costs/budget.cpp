// Chapter 16 - The error budget of one problem: who is to blame for how much.
// Run:  make ch16     Reads: nothing     Writes: ch16_budget.results, budget.md
// --full: the reference on a mesh that is four times finer.
#include <array>
#include <iostream>

#include "addons/estimate/estimate.hpp"
#include "runs.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/solvers/solvers.hpp"

namespace {

using namespace ch16;

// 1. What is asked for: the largest pressure and the half-width, in percent of the closed form.
using Values = std::array<double, 2>;
const std::array<Goal, 2> goals = {{{"q0", PeakPressure{}}, {"b", HalfWidth{}}}};
const LineContact theory = HertzProblem().theory();
const Values exact = {hertz_peak_pressure(theory), hertz_half_width(theory)};

Values read(const SolvedScene& run) {
  Values out{};
  for (std::size_t k = 0; k < goals.size(); ++k)
    out[k] = 100 * value(run.model, run.solution, goals[k]) / exact[k];
  return out;
}

SolvedScene run_of(const HertzProblem& problem, Quadrature where = Quadrature::Segments) {
  Scene scene = signorini_test::scene_of(problem);
  scene.contacts[0].quadrature = where;
  scene.contacts[0].points = where == Quadrature::Segments ? 0 : 2;
  return solved(scene, "Hertz's contact");
}

// 2. Each step takes one cause away, so that the differences add up to the whole error.
struct Budget {
  std::vector<std::pair<std::string, Values>> without;  // this cause and all before it
  std::vector<Estimate> estimates;                      // from the coarse mesh alone
};

// [causes]
Budget budget(bool full) {
  HertzProblem coarse;
  coarse.mesh = meshes(16, 13);
  SolvedScene ours = run_of(coarse, Quadrature::SourceEdges);
  const Values refined = read(ours);
  // Plain doubles.
  ours.solution.contact.force = coarse.solver.solve(ours.condensed.problem, {}).force;
  const SolvedScene gaps = run_of(coarse);  // on segments
  HertzProblem fine = coarse;               // second order, and 16 times as many elements
  fine.element = "q8";
  fine.mesh = meshes(full ? 128 : 64, full ? 104 : 52);
  HertzProblem wide = fine;  // and a plate four times as wide and deep
  wide.mesh.plate *= 4;
  wide.mesh.plate_layers = wide.mesh.plate_layers * 3 / 2;
  Ledger unused;
  return {
      {{"", read(ours)},
       {"algebra: plain doubles", refined},
       {"gaps: two points on an edge", read(gaps)},
       {"elements", read(run_of(fine))},
       {"domain: a plate of 95 mm", read(run_of(wide))},
       {"theory: half-planes, a parabola", {100, 100}}},
      estimates(gaps.model, gaps.condensed, gaps.solution, {goals.begin(), goals.end()}, unused)};
}
// [causes]

SolveStatus chapter(const ProgramOptions& run) {
  if (run.full) std::cout << "--full: the reference has four times the elements, half a minute\n";
  Results results("ch16_budget");
  Table table({"cause", "$`q_0`$ [%]", "estimated", "$b$ [%]", "estimated"});
  const Budget found = budget(run.full);
  const auto row = [&](const std::string& cause, const Values& with, const Values& without) {
    std::vector<std::string> cells = {cause};
    for (std::size_t k = 0; k < goals.size(); ++k) {
      const double part = with[k] - without[k];
      cells.push_back(std::abs(part) < 5e-6 ? "below 0.00001" : number(part, "%+.4f"));
      cells.push_back(cause == "elements"
                          ? number(100 * std::abs(found.estimates[k].error) / exact[k], "%.3f")
                          : "");
    }
    table.row(std::move(cells));
  };
  for (std::size_t k = 1; k < found.without.size(); ++k)
    row(found.without[k].first, found.without[k - 1].second, found.without[k].second);
  row("all", found.without.front().second, found.without.back().second);
  write_file(run.out / "budget.md", table.markdown());
  std::cout << table.markdown();
  results.add("peak_error", found.without[0].second[0] - 100, "%");
  results.add("peak_error_exact_gaps", found.without[2].second[0] - 100, "%");
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch16_budget", "The error budget of one problem", SIGNORINI_CHAPTER_OUT, argc,
                     argv, chapter);
}

// Chapter 16 - The error budget of one problem: who is to blame for how much.
// Run:  make ch16     Reads: nothing     Writes: ch16_budget.results, budget.md
// --full: the reference on a mesh that is four times finer.
#include <iostream>

#include "runs.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/solvers/solvers.hpp"

namespace {

using namespace ch16;

// 1. What is asked for: the largest pressure and the half-width, in percent of the closed form.
struct Reading {
  double peak = 0, width = 0;
};

Reading reading(const HertzProblem& problem, const Pressures& at) {
  const LineContact theory = problem.theory();
  const bool quadratic = find_element(problem.element).n_nodes > 4;
  const double width =
      half_width_of_forces(at.x, at.force, quadratic ? Trace::Quadratic : Trace::Linear);
  return {100 * fit_hertz(at.x, at.pressure).peak_pressure / hertz_peak_pressure(theory),
          100 * width / hertz_half_width(theory)};
}

SolvedScene run_of(const HertzProblem& problem, Quadrature where, int points) {
  Scene scene = signorini_test::scene_of(problem);
  scene.contacts[0].quadrature = where;
  scene.contacts[0].points = points;
  return solved(scene, "Hertz's contact");
}

// 2. Each step takes one cause away, so that the differences add up to the whole error.
// [causes]
std::vector<std::pair<std::string, Reading>> without_one_more(bool full) {
  HertzProblem coarse;
  coarse.mesh = meshes(16, 13);
  SolvedScene unrefined = run_of(coarse, Quadrature::SourceEdges, 2);
  const Pressures ours = pressures(unrefined);
  unrefined.solution.contact.force =
      find_solver(coarse.solver).solve(unrefined.condensed.problem, {}).force;  // plain doubles
  HertzProblem fine = coarse;  // second order, and 16 times as many elements
  fine.element = "q8";
  fine.mesh = meshes(full ? 128 : 64, full ? 104 : 52);
  HertzProblem wide = fine;  // and a plate four times as wide and deep
  wide.mesh.plate *= 4;
  wide.mesh.plate_layers = wide.mesh.plate_layers * 3 / 2;
  const auto exact = [](const HertzProblem& problem) {
    return reading(problem, pressures(run_of(problem, Quadrature::Segments, 0)));
  };
  return {{"", reading(coarse, pressures(unrefined))},
          {"algebra: plain doubles", reading(coarse, ours)},
          {"gaps: two points on an edge", exact(coarse)},
          {"elements", exact(fine)},
          {"domain: a plate of 95 mm", exact(wide)},
          {"theory: half-planes, a parabola", {100, 100}}};
}
// [causes]

Status chapter(const ProgramOptions& run) {
  if (run.full) std::cout << "--full: the reference has four times the elements, half a minute\n";
  Results results("ch16_budget");
  Table table({"cause", "$`q_0`$ [%]", "$b$ [%]"});
  const auto readings = without_one_more(run.full);
  const auto row = [&](const std::string& cause, const Reading& with, const Reading& without) {
    const auto cell = [](double part) {
      return std::abs(part) < 5e-6 ? "below 0.00001" : number(part, "%+.4f");
    };
    table.row({cause, cell(with.peak - without.peak), cell(with.width - without.width)});
  };
  for (std::size_t k = 1; k < readings.size(); ++k)
    row(readings[k].first, readings[k - 1].second, readings[k].second);
  row("all", readings.front().second, readings.back().second);
  write_file(run.out / "budget.md", table.markdown());
  std::cout << table.markdown();
  results.add("peak_error", readings.front().second.peak - 100, "%");
  results.add("peak_error_exact_gaps", readings[2].second.peak - 100, "%");
  results.add("width_error", readings.front().second.width - 100, "%");
  results.write(run.out);
  return Status::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch16_budget", "The error budget of one problem", SIGNORINI_CHAPTER_OUT, argc,
                     argv, chapter);
}

// Chapter 8 - A length against a force: the same cylinder in six systems of units (Lin et al., eq. 12).
// Run:  make ch08     Reads: nothing     Writes: ch08_units.results, units.md,
//       fig_8_4.csv
#include <algorithm>
#include <iostream>

#include "functions.hpp"
#include "papers/solver_table.hpp"
#include "problems.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;
using Eigen::VectorXd;

std::string small(double x) { return x < 1e-12 ? "below 1e-12" : number(x, "%.0e"); }

// 1. Units: the same cylinder in lengths and stresses of other sizes.
struct Units {
  const char* name;
  double length, force;  // a mm and a N are so many of them
};
const std::vector<Units> systems = {{"mm, MPa", 1, 1},      {"mm, GPa", 1, 1e-3},
                                    {"m, Pa", 1e-3, 1},     {"m, kPa", 1e-3, 1e-3},
                                    {"m, MPa", 1e-3, 1e-6}, {"m, GPa", 1e-3, 1e-9}};

ContactProblem measured_in(const Units& u, const ContactProblem& problem) {
  return {problem.compliance * (u.length / u.force), problem.free_gap * u.length};
}

double force_scale_of(const ContactProblem& problem) {  // the gap that forces 1 everywhere make
  return problem.compliance.cwiseAbs().rowwise().sum().maxCoeff();
}

void units(const ProgramOptions& run, Results& results) {
  const VectorXd exact = find_solver("quasi_active_set").solve(pressed_cylinder(), {}).force;
  const VectorXd none = VectorXd::Zero(exact.size());
  Table table({"units", "largest overlap", "largest force", "steps to 1e-8", "error of the forces",
               "steps to 1e-8 of the first", "their error", "steps, scaled", "their error"});
  Table figure({"step", "residual", "error"});
  Eigen::Vector3d worst(0, 0, 0);
  for (const Units& u : systems) {
    const ContactProblem problem = measured_in(u, pressed_cylinder());
    const NewtonRun ways[] = {
        newton(problem, functions[0], none, {1e-8, 0}),
        newton(problem, functions[0], none, {0, 1e-8}),
        newton(problem, functions[0], none, {0, 1e-8}, force_scale_of(problem))};
    const auto error = [&](const VectorXd& force) {
      return (force / u.force - exact).cwiseAbs().maxCoeff() / exact.maxCoeff();
    };
    std::vector<std::string> row = {u.name, number(-problem.free_gap.minCoeff(), "%.1e"),
                                    number(u.force * exact.maxCoeff(), "%.1e")};
    for (int k = 0; k < 3; ++k) {
      row.push_back(std::to_string(ways[k].steps()));
      row.push_back(small(error(ways[k].forces.back())));
      worst(k) = std::max(worst(k), error(ways[k].forces.back()));
    }
    table.row(row);
    if (&u != &systems.front() && &u != &systems.back() && &u != &systems[4]) continue;
    for (const double force_scale : {1.0, force_scale_of(problem)}) {
      const NewtonRun way = newton(problem, functions[0], none, {0, 1e-12}, force_scale);
      for (std::size_t k = 0; k <= way.steps(); ++k)
        figure.row({static_cast<double>(k), way.residuals[k], error(way.forces[k])});
      figure.blank_line();
    }
  }
  std::cout << table.markdown();
  write_file(run.out / "units.md", table.markdown());
  write_file(run.out / "fig_8_4.csv", figure.csv("rel 1e-3 abs 1e-9"));
  results.add("worst_error", worst(0), "-");
  results.add("worst_error_relative_test", worst(1), "-");
  results.add("worst_error_scaled", worst(2), "-", Repeats::No);
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch08_units");
  units(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch08_units", "A length against a force", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}

// Chapter 3 - Six rules compared: iterations until s is close to its best value.
// Run:  make ch03     Reads: nothing     Writes: ch03_rules.results, counts.md, counts_random.md,
//                                                fig_3_2.csv
#include <algorithm>
#include <iostream>

#include "papers/weight_iteration.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "three_problems.hpp"

namespace {

using namespace ch03;

// 1. Iterations until s* - s <= tolerance s*.
std::vector<std::string> counts(const ContactProblem& problem, double best, WeightRule rule) {
  WeightIteration run(problem, rule);
  std::vector<std::string> cells;
  int k = 0;
  for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8}) {
    while (best - run.value() > tolerance * best && k < 20000 && run.step()) ++k;
    cells.push_back(best - run.value() <= tolerance * best ? std::to_string(k) : "–");
  }
  return cells;
}

double best_value(const ContactProblem& problem) {
  const ContactState exact = surrogate_dual(problem, WeightRule::FullyCorrective);
  return -0.5 * exact.force.dot(problem.free_gap);
}

// 2. What is missing after k iterations, for figure 3.2.
void curve_of(const ContactProblem& problem, double best, WeightRule rule, Table& curve) {
  WeightIteration iteration(problem, rule);
  double next = 1;
  for (int k = 0; k <= 20000; ++k) {
    const double gap = std::max(1e-12, 1 - iteration.value() / best);
    if (k >= next || gap <= 1e-9) {
      curve.row({static_cast<double>(k), gap});
      next = std::max(k + 1.0, 1.15 * k);
    }
    if (!iteration.step() || gap <= 1e-9) break;
  }
  curve.blank_line();
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch03_rules");
  const std::vector<Named> problems = three_problems();
  const ContactProblem& punch = problems.front().problem;
  results.add("violated_by_u0", static_cast<double>((punch.free_gap.array() < 0).count()), "-");
  Table half_plane({"rule", "1e-2", "1e-4", "1e-6", "1e-8"});
  Table random({"problem", "rule", "1e-2", "1e-4", "1e-6", "1e-8"});
  Table curve({"iteration", "gap"});
  for (const auto& [name, problem] : problems) {
    const double best = best_value(problem);
    for (const Rule& rule : rules) {
      std::vector<std::string> row = counts(problem, best, rule.rule);
      if (rule.rule == WeightRule::FullyCorrective)
        results.add(text("corrective_", problem.free_gap.size()), std::stod(row.back()), "-");
      row.insert(row.begin(), rule.name);
      if (&problem == &punch) {
        half_plane.row(row);
        curve_of(problem, best, rule.rule, curve);
      } else {
        row.insert(row.begin(), name);
        random.row(row);
      }
    }
  }
  write_file(run.out / "counts.md", half_plane.markdown());
  write_file(run.out / "counts_random.md", random.markdown());
  write_file(run.out / "fig_3_2.csv", curve.csv("rel 1e-3 abs 1e-10"));
  std::cout << half_plane.markdown();
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch03_rules", "Six rules compared", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}

// Chapter 9 - The printed equations in other units (Lin et al., sec. 2.3, eq. 28).
// Run:  make ch09     Reads: nothing     Writes: ch09_units.results, units.md
#include <algorithm>
#include <iostream>

#include "papers/saddle_point_newton.hpp"
#include "round_block.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/scene/readings.hpp"

namespace {

using namespace ch09;
using namespace signorini;

std::string small(double x) { return x < 1e-12 ? "below 1e-12" : number(x, "%.0e"); }

// 1. The printed equations in other units.
void units(const ProgramOptions& run, Results& results) {
  const Eigen::VectorXd exact = solved(round_block(20, {"mm"}), "units").solution.contact.force;
  Table table({"units", "steps to 1e-6", "error of the forces", "steps to 1e-12", "error",
               "steps, scaled", "error "});
  double worst = 0;
  for (const Units& u : {Units{"mm, MN", 1, 1e-6}, Units{"mm, kN", 1, 1e-3}, Units{"mm, N", 1, 1},
                         Units{"m, kN", 1e-3, 1e-3}, Units{"m, N", 1e-3, 1}}) {
    Ledger ledger;
    const Model model = build(round_block(20, u), ledger);
    std::vector<std::string> row = {u.name};
    constexpr auto as_printed = SaddlePointForm::AsPrinted;
    for (const auto& [tolerance, form] :
         {std::pair(1e-6, as_printed), {1e-12, as_printed}, {1e-12, SaddlePointForm::OneUnit}}) {
      SaddlePointOptions options;
      options.tolerance = tolerance;
      options.form = form;
      const SaddlePointSolution end = saddle_point_newton(model.programme, options);
      const double error =
          (end.solution.force / u.force - exact).cwiseAbs().maxCoeff() / exact.maxCoeff();
      row.push_back(std::to_string(end.report.iterations));
      row.push_back(small(error));
      worst = std::max(worst, error);
    }
    table.row(row);
  }
  std::cout << table.markdown();
  write_file(run.out / "units.md", table.markdown());
  results.add("worst_error", worst, "-");
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch09_units");
  units(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch09_units", "The same bodies in other units", SIGNORINI_CHAPTER_OUT, argc,
                     argv, chapter);
}

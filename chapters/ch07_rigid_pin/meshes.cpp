// Chapter 7 - Even cells along the half hole: 15 to compare programs digit by digit, then finer ones.
// Run:  make ch07     Reads: nothing     Writes: ch07_meshes.results, even.md, pressures.md, fig_7_2.csv
#include <iostream>
#include <tuple>

#include "pin.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch07;

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch07_meshes");
  std::vector<Column> exact = {{"θ [deg]", VectorXd::LinSpaced(8, 0, 84), "%.0f"}};
  std::vector<Column> fine = {{"θ [deg]", VectorXd::LinSpaced(5, 0, 80), "%.0f"}};
  std::vector<Column> curve;
  for (const auto& [name, title, pin] :
       {std::tuple("t", "(T) ", tension), std::tuple("c", "(C) ", compression)}) {
    const Bearing coarse = on_even_mesh(pin, 15, 15);
    exact.push_back({text(title, "[kN]"), coarse.force.head(8), "%.7f"});
    results.add(text("even_right_", name), coarse.right, "cm");
    for (const Index cells : {36, 72, 144}) {
      const Bearing now = on_even_mesh(pin, cells, cells / 2);
      fine.push_back({text(title, cells), now.pressure(Eigen::seqN(0, 5, cells / 9)), "%.2f"});
      if (cells < 144) continue;
      if (curve.empty()) curve.push_back({"theta", now.theta.head(73)});
      curve.push_back({name, now.pressure.head(73)});
      Index peak = 0;
      results.add(text("peak_", name), now.pressure.maxCoeff(&peak), "kN/cm^2");
      results.add(text("peak_angle_", name), now.theta(peak), "deg");
      const Index closed = (now.force.array() > 0).count();
      results.add(text("end_", name), now.theta(closed - 1), "deg");
      results.add(text("fine_right_", name), now.right, "cm");
    }
  }
  std::cout << table_of(fine).markdown();
  write_file(run.out / "even.md", table_of(exact).markdown());
  write_file(run.out / "pressures.md", table_of(fine).markdown());
  write_file(run.out / "fig_7_2.csv", table_of(curve).csv("rel 1e-6 abs 1e-8"));
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch07_meshes", "The pin on finer meshes", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}

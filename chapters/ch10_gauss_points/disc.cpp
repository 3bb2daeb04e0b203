// Chapter 10 - A disc whose nodes do not meet those of its plate (Lin et al., secs. 2.4 and 3.1).
// Run:  make ch10     Reads: nothing     Writes: ch10_disc.results, hertz.md, fig_10_3*.csv
#include <iostream>

#include "closed_points.hpp"
#include "interfaces.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch10;
using Eigen::Index;
using Eigen::VectorXd;

std::string percent(double x) { return number(100 * x, x < 0.995 ? "%.2g" : "%.0f"); }
const char* tolerance = "rel 1e-4 abs 1e-6";  // of the curves
const double q0 = hertz_peak_pressure(hertz_contact);
const double b = hertz_half_width(hertz_contact);

// 1. Pressures that are nodal forces over the nodes' shares, against the closed form.
// [lumped]
PressureError lumped_error(const Scene& scene, const SolvedScene& run) {
  const BoundaryForces nodes = boundary_forces(run, {"rim", scene.bodies[0].mesh.name});
  return against_hertz(nodes.position, nodes.weight,
                       nodes.force.col(1).cwiseQuotient(nodes.weight));
}
// [lumped]

// 2. A disc whose nodes do not meet those of the plate: pressures that are determined, and wrong.
void disc(const ProgramOptions& run, Results& results) {
  Table table({"points", "determined", "peak / q0", "rms error %", "lumped, rms error %",
               "finer: determined", "peak / q0", "rms error %", "lumped, rms error %"});
  for (int points = 1; points <= 4; ++points) {
    std::vector<std::string> row = {std::to_string(points)};
    for (const Index finer : {1, 2}) {
      const Scene scene = hertz(21, {"gauss_points", points}, finer);
      const SolvedScene now = solved(scene, "disc");
      const ClosedPoints closed = closed_points(now);
      const bool unique = closed.free.cols() == 0;
      const Pairs& pairs = now.model.pairs;
      const VectorXd p = now.solution.pressure / q0;
      const PressureError error = against_hertz(pairs.position, pairs.weight, q0 * p);
      const PressureError lumped = lumped_error(scene, now);
      row.insert(row.end(), {text(closed.rank, " of ", closed.points.size()),
                             unique ? number(error.peak, "%.2f") : "",
                             unique ? percent(error.rms) : "", percent(lumped.rms)});
      const std::string key = text(points, finer == 1 ? "" : "_finer");
      const Repeats repeats = unique ? Repeats::Yes : Repeats::No;
      results.add("peak_" + key, error.peak, "-", repeats);
      results.add("rms_" + key, 100 * error.rms, "%", repeats);
      results.add("lumped_" + key, 100 * lumped.rms, "%");
      if (points == 1 || finer == 2) continue;
      const char* panel[] = {"", "_three", "_four"};
      write_file(run.out / text("fig_10_3", panel[points - 2], ".csv"),
                 table_of({{"x", pairs.position.col(0) / b}, {"p", p}}).csv(tolerance));
    }
    table.row(row);
  }
  std::cout << table.markdown();
  write_file(run.out / "hertz.md", table.markdown());
  const SolvedScene nodal = solved(hertz(21, {"mortar", 0, Quadrature::Segments}), "disc");
  write_file(run.out / "fig_10_3_nodal.csv", table_of({{"x", nodal.model.pairs.position.col(0) / b},
                                                       {"p", nodal.solution.pressure / q0}})
                                                 .csv(tolerance));
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch10_disc");
  disc(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch10_disc", "The disc, nodes apart", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}

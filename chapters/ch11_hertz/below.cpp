// Chapter 11 - The largest shear below the surface against M'Ewen's, also for a contact ten times narrower.
// Run:  make ch11     Reads: nothing     Writes: ch11_below.results, shear.md, fig_11_8.csv, fig_11_8_disc.csv, fig_11_8_plate.csv
#include <iostream>

#include "hertz_run.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/scene/bodies.hpp"

namespace {

using namespace signorini;

// 1. Stress at the nodes of the line of symmetry of one body.
struct AxisStress {
  Eigen::VectorXd depth;          // from the contact [mm], not sorted
  Eigen::VectorXd xx, yy, shear;  // at these nodes [MPa]; shear = (xx - yy) / 2
  LargestShear largest;           // vertex of the parabola through the three nodes around it

  // Data of a figure, down to a depth [mm].
  [[nodiscard]] std::string csv(double end) const {
    Table table({"depth", "xx", "yy", "shear"});
    for (Eigen::Index k = 0; k < depth.size(); ++k)
      if (depth(k) <= end) table.row({depth(k), xx(k), yy(k), shear(k)});
    return table.csv("rel 1e-6 abs 1e-6");
  }
};

AxisStress along_axis(const SolvedScene& run, std::size_t body) {
  const BodyModel& model = run.model.bodies[body];
  const std::vector<Eigen::Index> nodes = boundary_nodes(model.mesh, "axis");
  const StressArray all =
      nodal_stress(model.mesh, model.element, model.material, run.solution.displacements[body]);
  AxisStress axis;
  axis.depth = model.mesh.nodes(nodes, 1).cwiseAbs();
  axis.xx = all(nodes, 0);
  axis.yy = all(nodes, 1);
  axis.shear = (axis.xx - axis.yy) / 2;
  Eigen::Index k = 0;
  axis.shear.segment(1, axis.shear.size() - 2).maxCoeff(&k);
  ++k;
  const double before = axis.depth(k - 1) - axis.depth(k);
  const double after = axis.depth(k + 1) - axis.depth(k);
  const double rise = (axis.shear(k - 1) - axis.shear(k)) / before;
  const double fall = (axis.shear(k + 1) - axis.shear(k)) / after;
  const double bend = (fall - rise) / (after - before);
  const double slope = rise - bend * before;
  axis.largest = {axis.depth(k) - slope / (2 * bend), axis.shear(k) - slope * slope / (4 * bend)};
  return axis;
}

// 2. Three meshes, and 1 % of the load on a contact of a tenth of the width: the bodies are larger.
void largest_shear(const ProgramOptions& run, Results& results) {
  Table table({"nodes", "P [N/mm]", "body", "depth/b", "error [%]", "shear/q0", "error [%]"});
  HertzCase narrow = finer(32, 24, 30);
  narrow.load /= 100;
  narrow.mesh.core /= 10;
  for (const HertzCase& now : {HertzCase{}, finer(32, 24, 30), finer(64, 48, 60), narrow}) {
    const SolvedScene solved = solve_hertz(now).run;
    const LargestShear exact = hertz_largest_shear(now.theory());
    for (const std::size_t body : {0, 1}) {
      const std::string& name = solved.model.bodies[body].mesh.name;
      const LargestShear got = along_axis(solved, body).largest;
      const double error = 100 * (got.stress / exact.stress - 1);
      results.add(text(name, now.load < 1 ? "_narrow" : text("_", now.mesh.disc_cells)), error,
                  "%");
      table.row({std::to_string(count_nodes(solved.model.bodies)), number(now.load, "%.4g"), name,
                 number(got.depth / hertz_half_width(now.theory()), "%.4f"),
                 number(100 * (got.depth / exact.depth - 1), "%+.2f"),
                 number(got.stress / hertz_peak_pressure(now.theory()), "%.4f"),
                 number(error, "%+.2f")});
    }
  }
  std::cout << table.markdown();
  write_file(run.out / "shear.md", table.markdown());
}

// 3. Stresses along the axis of the example.
void draw(const ProgramOptions& run) {
  const HertzRun ours = solve_hertz({});
  const LineContact theory = ours.now.theory();
  const double b = hertz_half_width(theory);
  write_file(run.out / "fig_11_8_disc.csv", along_axis(ours.run, 0).csv(4 * b));
  write_file(run.out / "fig_11_8_plate.csv", along_axis(ours.run, 1).csv(4 * b));
  Table exact({"depth", "xx", "yy", "shear"});
  for (int k = 0; k <= 200; ++k) {
    const Eigen::Vector3d stress = hertz_stress(theory, 0, 0.02 * k * b);
    exact.row({0.02 * k * b, stress(0), stress(1), (stress(0) - stress(1)) / 2});
  }
  write_file(run.out / "fig_11_8.csv", exact.csv());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch11_below");
  largest_shear(run, results);
  draw(run);
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch11_below", "Below the surface", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}

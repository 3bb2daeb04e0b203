// Chapter 14 - Stresses through both walls, by cells and in closed form.
// Run:  make ch14     Reads: nothing     Writes: ch14_walls.results, fig_14_4*.csv
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "rings.hpp"
#include "signorini/core/table.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;
using namespace ch14;

// Mean stresses of the cells of one body, in the directions of their middles.
struct CellStresses {
  Eigen::VectorXd
      radius;  // mean of the layer's [length]; the middle of a straight-sided cell is further in
  Eigen::VectorXd radial;  // [force/length^2], tension > 0
  Eigen::VectorXd hoop;    // [force/length^2], tension > 0
};

CellStresses cell_stresses(const SolvedScene& run, std::size_t body) {
  const BodyModel& model = run.model.bodies[body];
  const StressArray stress =
      cell_stress(model.mesh, model.element, model.material, run.solution.displacements[body]);
  const Index n = stress.rows();
  CellStresses out{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n)};
  for (Index cell = 0; cell < n; ++cell) {
    Eigen::RowVector2d middle(0, 0);
    for (Index k = 0; k < 4; ++k) middle += model.mesh.nodes.row(model.mesh.cells(cell, k)) / 4;
    const Index first = model.mesh.cells(cell, 0), opposite = model.mesh.cells(cell, 2);
    out.radius(cell) =
        (model.mesh.nodes.row(first).norm() + model.mesh.nodes.row(opposite).norm()) / 2;
    const Eigen::RowVector2d e = middle.normalized();
    out.radial(cell) = stress(cell, 0) * e.x() * e.x() + stress(cell, 1) * e.y() * e.y() +
                       2 * stress(cell, 2) * e.x() * e.y();
    out.hoop(cell) = stress(cell, 0) + stress(cell, 1) - out.radial(cell);
  }
  return out;
}

// Figure 14.4: stresses through both walls. Returns the largest deviation of a cell from the closed form.
double stresses_through_walls(const std::filesystem::path& out, const SolvedScene& now) {
  const NestedRings exact = closed_form(paper);
  const NestedPressure on = nested_pressure(exact);
  Table cells({"r", "radial", "hoop"});
  Table curves({"r", "radial", "hoop"});
  double worst = 0;
  for (const std::size_t body : {0, 1}) {
    const Ring& ring = body == 0 ? exact.inner : exact.outer;
    const RingPressure& load = body == 0 ? on.inner : on.outer;
    const CellStresses mean = cell_stresses(now, body);
    for (Index k = 0; k < paper.cells_radius; ++k) {  // of one ray: all nine are the same
      cells.row({mean.radius(k), mean.radial(k), mean.hoop(k)});
      const RingStress lame = ring_stress(ring, load, mean.radius(k));
      worst = std::max(
          {worst, std::abs(lame.radial - mean.radial(k)), std::abs(lame.hoop - mean.hoop(k))});
    }
    const Eigen::VectorXd radii =
        Eigen::VectorXd::LinSpaced(41, ring.inner_radius, ring.outer_radius);
    for (const double r : radii) {
      const RingStress lame = ring_stress(ring, load, r);
      curves.row({r, lame.radial, lame.hoop});
    }
    curves.blank_line();
  }
  write_file(out / "fig_14_4.csv", curves.csv());
  write_file(out / "fig_14_4_cells.csv", cells.csv("rel 1e-6 abs 1e-6"));
  return worst;
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch14_walls");
  results.add("stress_worst", stresses_through_walls(run.out, run_of(paper)), "MPa");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch14_walls", "Stresses through both walls", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}

// Chapter 1 - The unilateral contact problem (Xuan & Li 2002, sec. 1): a block on an obstacle.
// Run:  make ch01     Reads: nothing     Writes: ch01.results, fig_1_1.csv, fig_1_1_obstacle.csv,
//      fig_1_1_nodes.csv, fig_1_5.csv, fig_1_5_*.csv, ch01.vtu
// --full: the mesh of 640 x 320 cells that the headline is compared with.
#include <cmath>

#include "addons/vtu/vtu.hpp"
#include "block_on_obstacle.hpp"
#include "papers/field_csv.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/pressure_table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/report/shown.hpp"
#include "signorini/scene/readings.hpp"

namespace {

using namespace ch01;
using Eigen::Index;

const double reference_force = 10.5451;  // on 640 x 320 cells [N]

Eigen::VectorXd obstacle_at(const Eigen::VectorXd& x) {  // height of the obstacle
  return (radius * radius - x.array().square()).sqrt() - radius;
}

// 1. The sketch of figure 1.1: the mesh of 8 x 4 cells, its nine candidates, and the obstacle.
void sketch(const ProgramOptions& run) {
  const Mesh mesh = block_on_obstacle(8).bodies[0].mesh;
  Table cells({"x", "y"});
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    for (const Index corner : {0, 1, 2, 3, 0}) {
      const Index node = mesh.cells(cell, corner);
      cells.row({mesh.nodes(node, 0), mesh.nodes(node, 1)});
    }
    cells.blank_line();
  }
  write_file(run.out / "fig_1_1.csv", cells.csv());
  const NodeArray base = mesh.nodes(boundary_nodes(mesh, "bottom"), Eigen::all);
  write_file(run.out / "fig_1_1_nodes.csv",
             table_of({{"x", base.col(0)}, {"y", base.col(1)}}).csv());
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(57, -28, 28);
  write_file(run.out / "fig_1_1_obstacle.csv", table_of({{"x", x}, {"y", obstacle_at(x)}}).csv());
}

// Where the pressure ends: it falls like a square root, so p^2 is a straight line there.
double half_width(const SolvedScene& block) {
  const Index last = block.solution.contact.active().back();
  const double p1 = std::pow(block.solution.pressure(last), 2);
  const double p2 = std::pow(block.solution.pressure(last - 1), 2);
  const double x1 = block.model.pairs.position(last, 0);
  return x1 + p1 / (p2 - p1) * (x1 - block.model.pairs.position(last - 1, 0));
}

// 2. The block pressed onto the obstacle, for figure 1.5.
void pressed(const ProgramOptions& run, const SolvedScene& block) {
  const Pairs& pairs = block.model.pairs;
  const Mesh& mesh = block.model.bodies[0].mesh;
  const NodeArray& u = block.solution.displacements[0];
  const NodeArray moved = pairs.position + u(pairs.node, Eigen::all);
  write_file(run.out / "fig_1_5_block.csv",
             deformed_cells_csv(mesh, u, Eigen::VectorXd::Zero(mesh.n_cells())));
  write_file(run.out / "fig_1_5_arrows.csv",
             pressure_arrows_csv(moved, pairs.normal, block.solution.pressure));
}

// 3. Gap and pressure along the base, for figure 1.5, and what the text quotes of them.
void gap_and_pressure(const ProgramOptions& run, const SolvedScene& block, Results& results) {
  const Pairs& pairs = block.model.pairs;
  write_file(run.out / "fig_1_5.csv",
             pressure_csv(block.model, block.solution, "rel 1e-6 abs 1e-8"));
  const Eigen::VectorXd x = pairs.position.col(0);
  write_file(run.out / "fig_1_5_obstacle.csv",
             table_of({{"x", x}, {"y", obstacle_at(x)}}).csv("rel 1e-6 abs 1e-8"));
  write_vtu(run.out / "ch01.vtu", block.model, block.solution);
  const Resultants sum = resultants(block.model, block.solution);
  results.add("candidates", static_cast<double>(block.model.programme.A.rows()), "-");
  results.add("unknowns", static_cast<double>(block.model.programme.load.size()), "-");
  results.add("closed", static_cast<double>(block.solution.contact.active().size()), "-");
  results.add("total_contact_force", sum.force.y(), "N");
  results.add("peak_pressure", sum.peak_pressure, "N/mm^2");
  results.add("half_width", half_width(block), "mm");
  results.add("certificate", block.solution.certificate.worst(), "-", Repeats::No);
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch01");
  sketch(run);
  pressed(run, solved(block_on_obstacle(32), "the block on 32 x 16 cells"));
  gap_and_pressure(run, shown(block_on_obstacle(160), "the block"), results);
  if (run.full) {
    const SolvedScene fine = shown(block_on_obstacle(640), "the block");
    results.add("fine_force", resultants(fine.model, fine.solution).force.y(), "N", Repeats::No);
  }
  results.add("reference_force", reference_force, "N");
  results.headline("total_contact_force", reference_force, "mesh of 640 x 320 cells, --full");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch01", "The unilateral contact problem", SIGNORINI_CHAPTER_OUT,
                                argc, argv, chapter);
}

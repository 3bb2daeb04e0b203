// Chapter 1 - The unilateral contact problem (Xuan & Li 2002, sec. 1, eqs. 1-13).
// Run:  make ch01     Reads: nothing     Writes: ch01.results, candidates.md, fig_1_1.csv,
//      fig_1_1_obstacle.csv, fig_1_1_nodes.csv, fig_1_2.csv, fig_1_3.csv, fig_1_3_nodes.csv,
//      fig_1_3_arrows.csv, fig_1_4.csv, fig_1_4_obstacle.csv, ch01.vtu
#include <cmath>
#include <limits>
#include <random>

#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/mesh/block.hpp"
#include "signorini/report/pressure_table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/shown.hpp"
#include "signorini/report/vtu.hpp"
#include "signorini/scene/readings.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "two_bodies.hpp"

namespace {

using namespace signorini;
using Eigen::Index;
using Eigen::Vector2d;

// 1. A rubber block, 40 mm x 20 mm, whose top is pressed down by 1 mm onto a round obstacle.
// [scene]
const double radius = 60;                // of the obstacle [mm]
const double reference_force = 10.5451;  // on 640 x 320 cells [N]
Scene block_on_obstacle(Index cells_x) {
  Scene scene;
  Body& body = scene.bodies[0];
  BlockSpec block;
  block.corner = {-20, 0};
  block.size = {40, 20};
  block.cells_x = cells_x;
  block.cells_y = cells_x / 2;
  body.mesh = make_block(block);
  body.material = {/*E [N/mm^2]*/ 10, /*nu*/ 0.3, PlaneState::Strain, /*thickness [mm]*/ 1};
  body.supports = {prescribed("top", Axis::X, 0.0), prescribed("top", Axis::Y, -1.0)};
  scene.contacts = {{{"bottom"}, disc({0, -radius}, radius)}};
  return scene;
}
// [scene]

// 2. From the scene to the quadratic programme (11)-(12), and to its solution.
SolvedScene solve_block(Index cells_x) { return shown(block_on_obstacle(cells_x), "the block"); }

// The sketch of figure 1.1: the mesh of the table, its candidates, and the obstacle.
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
  const Eigen::ArrayXd x = Eigen::ArrayXd::LinSpaced(57, -28, 28);
  const Eigen::ArrayXd y = (radius * radius - x.square()).sqrt() - radius;
  write_file(run.out / "fig_1_1_obstacle.csv", table_of({{"x", x}, {"y", y}}).csv());
}

// 3. Nine candidates: all 2^9 sets of closed pairs are tried, and one fits.
void try_all_sets(const ProgramOptions& run, Results& results) {
  const SolvedScene block = solve_block(8);
  const ContactState tried = enumerate(block.condensed.problem);
  if (tried.report.status != Status::Solved) throw NotSolved("no set of closed pairs fits");
  if (tried.active != block.solution.contact.active)
    throw NotSolved("enumeration and active set method disagree");
  const Table table =
      table_of({{"x [mm]", block.model.pairs.position.col(0), "%.0f"},
                {"gap without contact [mm]", block.condensed.problem.free_gap, "%.3f"},
                {"gap [mm]", tried.gap, "%.3f"},
                {"contact force [N]", tried.force, "%.3f"}});
  write_file(run.out / "candidates.md", table.markdown());
  results.add("small_candidates", static_cast<double>(tried.gap.size()), "-");
  results.add("small_closed", static_cast<double>(tried.active.size()), "-");
}

// \PaperEq{XuanLi2002, 7}, \PaperEq{XuanLi2002, 8}
// 4. The variational inequality (7) on random displacements w: (K u - p).(w - u) >= 0 if A w <= g.
// [inequality]
void check_inequality(const SolvedScene& block, Results& results) {
  const QuadraticProgramme& programme = block.model.programme;
  const Eigen::VectorXd& u = block.solution.refined.displacement;
  const Eigen::VectorXd force = programme.stiffness * u - programme.load;
  const Eigen::VectorXd rounding =  // of each entry of it: a row of K has at most 18 terms
      18 * std::numeric_limits<double>::epsilon() *
      (programme.stiffness.cwiseAbs() * u.cwiseAbs() + programme.load.cwiseAbs());
  std::mt19937_64 engine(1);
  const auto uniform = [&] { return std::ldexp(static_cast<double>(engine() >> 11), -52) - 1; };
  int admissible_violate = 0;
  int free_violate = 0;
  for (int sample = 0; sample < 1000; ++sample) {
    const double size = std::pow(10.0, -sample % 5);  // near u and far from it [mm]
    Eigen::VectorXd w = u.unaryExpr([&](double value) { return value + size * uniform(); });
    free_violate += force.dot(w - u) < 0 ? 1 : 0;
    // Move every overlapping node back along its normal: one unit vector per row of A.
    const Eigen::VectorXd overlap = (programme.A * w - programme.initial_gap).cwiseMax(0.0);
    w -= programme.A.transpose() * overlap;
    admissible_violate += force.dot(w - u) < -rounding.dot((w - u).cwiseAbs()) ? 1 : 0;
  }
  // [inequality]
  results.add("samples", 1000, "-");
  results.add("admissible_violate", admissible_violate, "-");
  results.add("inadmissible_violate", free_violate, "-");
}

// Where the pressure ends: it falls like a square root, so p^2 is a straight line there.
double half_width(const SolvedScene& block) {
  const Index last = block.solution.contact.active.back();
  const double p1 = std::pow(block.solution.pressure(last), 2);
  const double p2 = std::pow(block.solution.pressure(last - 1), 2);
  const double x1 = block.model.pairs.position(last, 0);
  return x1 + p1 / (p2 - p1) * (x1 - block.model.pairs.position(last - 1, 0));
}

// 5. Gap and pressure along the base, for figure 1.4.
void gap_and_pressure(const ProgramOptions& run, const SolvedScene& block, Results& results) {
  const Pairs& pairs = block.model.pairs;
  write_file(run.out / "fig_1_4.csv",
             pressure_csv(block.model, block.solution, "rel 1e-6 abs 1e-8"));
  const Eigen::VectorXd x = pairs.position.col(0);
  const NodeArray moved = pairs.position + block.solution.displacements[0](pairs.node, Eigen::all);
  const Table outline =
      table_of({{"x", x},
                {"obstacle", (radius * radius - x.array().square()).sqrt() - radius},
                {"base_x", moved.col(0)},
                {"base_y", moved.col(1)}});
  write_file(run.out / "fig_1_4_obstacle.csv", outline.csv("rel 1e-6 abs 1e-8"));
  write_vtu(run.out / "ch01.vtu", block.model, block.solution);
  const Resultants sum = resultants(pairs, block.solution);
  results.add("candidates", static_cast<double>(block.model.programme.A.rows()), "-");
  results.add("closed", static_cast<double>(block.solution.contact.active.size()), "-");
  results.add("total_contact_force", sum.force.y(), "N");
  results.add("peak_pressure", sum.peak_pressure, "N/mm^2");
  results.add("half_width", half_width(block), "mm");
  results.add("certificate", block.solution.certificate.worst(), "-", Repeats::No);
}

// 6. The gap (2), printed with one division too many, of points 1 mm off the obstacle.
// [gap]
void gap_formulas(const ProgramOptions& run, Results& results) {
  const Obstacle curve =
      profile([](double x) { return std::sqrt(radius * radius - x * x) - radius; },
              [](double x) { return -x / std::sqrt(radius * radius - x * x); });
  Table table({"angle", "repaired", "printed"});  // true distance: 1 mm
  for (int degrees = 0; degrees <= 60; degrees += 3) {
    const double angle = degrees * std::acos(-1.0) / 180;
    const Vector2d normal(std::sin(angle), std::cos(angle));
    const Vector2d point = Vector2d(0, -radius) + (radius + 1) * normal;
    const ObstacleContact seen = curve.look(point);
    const double printed = seen.gap * seen.normal.y();  // the root once more in the denominator
    table.row({static_cast<double>(degrees), seen.gap, printed});
    // [gap]
    if (degrees == 45) {
      results.add("repaired_gap_45", seen.gap, "mm");
      results.add("printed_gap_45", printed, "mm");
    }
  }
  write_file(run.out / "fig_1_2.csv", table.csv());
}

Status chapter(const ProgramOptions& run) {
  Results results("ch01");
  sketch(run);
  try_all_sets(run, results);
  const SolvedScene block = solve_block(160);
  check_inequality(block, results);
  gap_and_pressure(run, block, results);
  gap_formulas(run, results);
  const ch01::TwoBodies bodies;  // 7. The relative displacements of two bodies.
  ch01::check_kinematics(bodies, results);
  ch01::draw_two_bodies(run.out, bodies);
  if (run.full) {  // the mesh that the headline is compared with
    const SolvedScene fine = solve_block(640);
    results.add("fine_force", resultants(fine.model.pairs, fine.solution).force.y(), "N",
                Repeats::No);
  }
  results.add("reference_force", reference_force, "N");
  results.headline("total_contact_force", reference_force, "mesh of 640 x 320 cells, --full");
  results.print();
  results.write(run.out);
  return Status::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch01", "The unilateral contact problem", SIGNORINI_CHAPTER_OUT,
                                argc, argv, chapter);
}

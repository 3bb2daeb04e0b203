// Chapter 6 - The contact pressure on 200 x 20 cells beside that of two beams, and the deformed beam.
// Run:  make ch06     Reads: nothing     Writes: ch06_pressure.results, pressure.csv, fig_6_3.csv, fig_6_4.csv,
//                                                fig_6_4_*.csv, ch06.vtu
#include "addons/vtu/vtu.hpp"
#include "papers/field_csv.hpp"
#include "papers/zero_line_csv.hpp"
#include "scene.hpp"
#include "signorini/core/table.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/report/pressure_table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/report/shown.hpp"

namespace {

using namespace ch06;

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch06_pressure");
  const SolvedScene q4 = solve_cantilever(paper, "q4", 200);
  const SolvedScene fine =
      shown(cantilever(paper, "q4_incompatible", 200), "the cantilever of 200 x 20 cells");
  const SolvedScene q8 = solve_cantilever(paper, "q8", 100);  // as many nodes on the lower side
  const double s = euler_bernoulli(paper).touchdown;
  const Eigen::VectorXd x = fine.model.pairs.position.col(0);
  const auto thin = [s](double at) { return at < s ? 0 : paper.pressure; };
  const auto thick = [](double at) { return timoshenko_pressure(paper, at); };
  const Table curve = table_of({{"x", x},
                                {"q4", q4.solution.pressure},
                                {"q4_incompatible", fine.solution.pressure},
                                {"q8", q8.solution.pressure},
                                {"euler_bernoulli", x.unaryExpr(thin)},
                                {"timoshenko", x.unaryExpr(thick)}});
  write_file(run.out / "fig_6_3.csv", curve.csv("rel 1e-6 abs 1e-7"));
  write_file(run.out / "pressure.csv", pressure_csv(fine.model, fine.solution));
  write_vtu(run.out / "ch06.vtu", fine.model, fine.solution);
  const SolvedScene coarse = solve_cantilever(paper, "q4_incompatible", 100);
  const BodyModel& body = coarse.model.bodies[0];
  const NodeArray& u = coarse.solution.displacements[0];
  const StressArray cells = cell_stress(body.mesh, body.element, body.material, u);
  const StressArray nodes = nodal_stress(body.mesh, body.element, body.material, u);
  write_file(run.out / "fig_6_4.csv", deformed_cells_csv(body.mesh, u, cells.col(0)));
  write_file(run.out / "fig_6_4_zero.csv", deformed_zero_line_csv(body.mesh, u, nodes.col(0)));
  const Pairs& pairs = coarse.model.pairs;
  const NodeArray moved = pairs.position + u(pairs.node, Eigen::all);
  write_file(run.out / "fig_6_4_arrows.csv",
             pressure_arrows_csv(moved, pairs.normal, coarse.solution.pressure));
  Index peak = 0;
  results.add("peak_pressure", fine.solution.pressure.maxCoeff(&peak), "kN/cm^2");
  results.add("peak_position", fine.model.pairs.position(peak, 0), "cm");
  results.add("touchdown", fine.model.pairs.position(fine.solution.contact.active().front(), 0),
              "cm");
  results.add("euler_bernoulli_touchdown", s, "cm");
  results.add("euler_bernoulli_point_force", euler_bernoulli(paper).point_force, "kN");
  results.add("timoshenko_touchdown", timoshenko(paper).touchdown, "cm");
  results.add("timoshenko_tip_force", timoshenko(paper).point_force, "kN");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch06_pressure", "The pressure", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}

// Chapter 16 - Knobs that buy nothing, and one that is cheap: points, tolerance, the last eight digits.
// Run:  make ch16     Reads: nothing     Writes: ch16_knobs.results, fig_16_6.csv, fig_16_6_sweeps.csv, fig_16_6_digits.csv
#include <iostream>

#include "scenes.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/solvers/solvers.hpp"

namespace {

using namespace ch16;

// 1. Points of the mortar operator, on whole edges and on segments that end where the target has a node.
void points(const ProgramOptions& run) {
  Table table({"points", "edges", "segments"});
  for (int count = 1; count <= 10; ++count) {
    std::vector<double> errors;
    for (const Quadrature where : {Quadrature::SourceEdges, Quadrature::Segments}) {
      HertzProblem problem;
      problem.mesh = meshes(32, 26);
      Scene scene = signorini_test::scene_of(problem);
      scene.contacts[0].points = count;
      scene.contacts[0].quadrature = where;
      const SolvedScene now = solved(scene, "Hertz's contact");
      errors.push_back(pressure_error(pressures(now), problem.theory()));
    }
    table.row({text(count), number(errors[0]), number(errors[1])});
  }
  write_file(run.out / "fig_16_6.csv", table.csv("rel 1e-4 abs 1e-6"));
}

// 2. Sweeps that come closer and closer, none of which is exact: how many are worth while? The disc is pushed.
void sweep(const ContactProblem& problem, Eigen::VectorXd& force) {
  for (Index i = 0; i < force.size(); ++i) {
    const double gap = problem.free_gap(i) + problem.compliance.row(i).dot(force);
    force(i) = std::max(0.0, force(i) - gap / problem.compliance(i, i));
  }
}

void sweeps(const ProgramOptions& run, Results& results) {
  Scene scene = hertz(16);
  scene.bodies[0].loads = {};
  scene.bodies[0].supports.push_back(prescribed("middle", Axis::Y, -0.06));
  SolvedScene now = solved(scene, "a pushed disc");
  const Eigen::VectorXd exact = now.solution.contact.force;
  HertzProblem problem;
  problem.load = 2 * exact.sum();
  const double mesh = pressure_error(pressures(now), problem.theory());
  Table table({"sweeps", "error", "of_solver", "of_mesh"});
  Eigen::VectorXd& force = now.solution.contact.force;
  force.setZero();
  int worth_while = 0;
  for (int count = 1; count <= 256; ++count) {
    sweep(now.condensed.problem, force);
    const double of_solver = 100 * (force - exact).norm() / exact.norm();
    if (of_solver > mesh) worth_while = count + 1;
    if ((count & (count - 1)) == 0)
      table.row({static_cast<double>(count), pressure_error(pressures(now), problem.theory()),
                 of_solver, mesh});
  }
  write_file(run.out / "fig_16_6_sweeps.csv", table.csv("rel 1e-3 abs 1e-9"));
  results.add("mesh_error", mesh, "%");
  results.add("sweeps_worth_while", worth_while, "-");
}

// 3. The last eight digits: plain doubles, and the refined end, on longer and longer beams.
void digits(const ProgramOptions& run, Results& results) {
  Table table({"slender", "share", "doubles ≈", "refined ≈", "forces ≈"});
  for (const double slender : {10.0, 20.0, 40.0, 80.0, 160.0}) {
    Scene scene = cantilever(8);
    scene.bodies[0].mesh.nodes.col(0) *= slender / 10;
    const SolvedScene now = solved(scene, "the beam");
    const ContactState state = now.model.solver.solve(now.condensed.problem, {});
    const QuadraticProgramme& posed = now.model.programme;
    PrimalDual plain{now.condensed.free_displacement, {}, state.force};
    plain.displacement -= now.condensed.factor.solve(posed.A.transpose() * state.force);
    const Ledger& ledger = now.solution.ledger;
    const double share =
        static_cast<double>(ledger.counted("refinement", "operations")) / operations(ledger);
    table.row({number(slender), number(share), number(certify(posed, plain).worst(), "%.1e"),
               number(now.solution.certificate.worst(), "%.1e"),
               number((state.force - now.solution.contact.force).norm() /
                          now.solution.contact.force.norm(),
                      "%.1e")});
    if (slender == 10) results.add("refinement_share", 100 * share, "%");
    if (slender == 160) results.add("refinement_share_of_160", 100 * share, "%");
  }
  write_file(run.out / "fig_16_6_digits.csv", table.csv());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch16_knobs");
  points(run);
  sweeps(run, results);
  digits(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch16_knobs", "Knobs", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}

// Chapter 6 - A cantilever on a rigid foundation (Xuan & Li 2002, sec. 4, example 2).
// Run:  make ch06     Reads: nothing     Writes: ch06.results, elements.md, history.md, units.md,
//                                                pressure.csv, fig_6_1.csv, fig_6_2.csv, fig_6_2_body.csv,
//                                                fig_6_3.csv, fig_6_4.csv, fig_6_4_zero.csv, fig_6_5_*.csv,
//                                                fig_6_6.csv, fig_6_6_tree.csv,
//                                                ch06.vtu
#include <algorithm>
#include <iostream>
#include <tuple>
#include <utility>
#include <vector>

#include "elimination.hpp"
#include "signorini/closed_form/beam.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/elasticity/stress.hpp"
#include "signorini/mesh/block.hpp"
#include "signorini/report/field_csv.hpp"
#include "signorini/report/pressure_table.hpp"
#include "signorini/report/printed_method.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/shown.hpp"
#include "signorini/report/vtu.hpp"
#include "signorini/scene/readings.hpp"
#include "signorini/solvers/linear_programme.hpp"

namespace {

using namespace signorini;
using Eigen::Index;

// 1. The data of the paper, as we read them, in cm and kN: a beam 1 cm above the foundation; width ours.
// [data]
const BeamOnFoundation paper{/*length*/ 50,     /*height*/ 5,           /*width*/ 1,
                             /*modulus*/ 2.1e4, /*poisson_ratio*/ 0.29, /*gap*/ 1,
                             /*pressure*/ 3.6};
const double total_force_2d = 71.626;  // limit of our own meshes up to 800 x 80 [kN]
// [data]

// 2. The scene: what a user writes down. All lengths and forces come from `beam`.
// [scene]
Scene cantilever(const BeamOnFoundation& beam, const std::string& element, Index cells) {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = block("cantilever", {0, 0}, {beam.length, beam.height}, cells, cells / 10,
                    element == "q8" ? MeshOrder::Quadratic : MeshOrder::Linear);
  body.element = element;
  body.material = {beam.youngs_modulus, beam.poisson_ratio, PlaneState::Stress, beam.width};
  body.supports = {fixed("left")};
  body.loads.edges = {{"top", beam.pressure, {}}};
  scene.contacts = {{{"bottom"}, half_plane({0, -beam.gap}, {0, 1})}};
  return scene;
}
// [scene]

// 3. From the scene to certified pressures.
// [solve]
SolvedScene solve_cantilever(const BeamOnFoundation& beam, const std::string& element,
                             Index cells) {
  return solved(cantilever(beam, element, cells), "the cantilever");
}
// [solve]

double total_force(const SolvedScene& run) {
  return resultants(run.model.pairs, run.solution).force.y();
}

// 4. The load history: nothing touches, the tip touches, a line touches.
void load_history(const ProgramOptions& run, Results& results) {
  Table table({"q [kN/cm²]", "closed nodes", "force [kN]", "Euler-Bernoulli", "Timoshenko"});
  Table beams({"q", "euler_bernoulli", "timoshenko"});
  Table body({"q", "force", "euler_bernoulli"});
  for (int step = 0; step <= 100; ++step) {
    BeamOnFoundation beam = paper;
    beam.pressure = 0.04 * step;
    const double thin = euler_bernoulli(beam).total_force;
    const double thick = timoshenko(beam).total_force;
    beams.row({beam.pressure, thin, thick});
    if (step % 5 != 0) continue;  // every 0.2
    const SolvedScene now = solve_cantilever(beam, "q4_incompatible", 100);
    const double force = total_force(now);
    body.row({beam.pressure, force, thin});
    if (step == 5 || step == 25 || step == 50 || step == 90)
      table.row({number(beam.pressure, "%.1f"), std::to_string(now.solution.contact.active.size()),
                 number(force, "%.3f"), number(thin, "%.3f"), number(thick, "%.3f")});
    if (step == 25) results.add("tip_force", force, "kN");
  }
  write_file(run.out / "history.md", table.markdown());
  write_file(run.out / "fig_6_2.csv", beams.csv());
  write_file(run.out / "fig_6_2_body.csv", body.csv());
}

// 5. Four elements on four meshes: the total force, and how far it is from its limit.
// [elements]
void compare_elements(const ProgramOptions& run, Results& results) {
  const std::vector<std::string> names = {"q4", "q4_bbar", "q4_incompatible", "q8"};
  Table table({"mesh", names[0], names[1], names[2], names[3]});
  double certificate = 0;
  double in_doubles = 0;
  for (const Index cells : {50, 100, 200, 400}) {
    std::vector<std::string> row = {text(cells, " x ", cells / 10)};
    for (const std::string& name : names) {
      const SolvedScene now = solve_cantilever(paper, name, cells);
      const double force = total_force(now);
      results.add(text("force_", name, '_', cells), force, "kN");
      row.push_back(number(force, "%.3f ") + number(100 * (force / total_force_2d - 1), "(%+.3f)"));
      certificate = std::max(certificate, now.solution.certificate.worst());
      const PrimalDual rounded{now.solution.refined.displacement, {}, now.solution.refined.force};
      in_doubles = std::max(in_doubles, certify(now.model.programme, rounded).equilibrium);
    }
    table.row(row);
  }
  // [elements]
  write_file(run.out / "elements.md", table.markdown());
  if (certificate > 1e-12) throw NotSolved("a certificate of the chapter exceeds 1e-12");
  results.add("worst_certificate", certificate, "-", Repeats::No);
  results.add("equilibrium_in_doubles", in_doubles, "-", Repeats::No);
}

// 6. The contact pressure on 200 x 20 cells, for figure 6.3, and the deformed beam.
void contact_pressure(const ProgramOptions& run, Results& results) {
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
  Index peak = 0;
  results.add("peak_pressure", fine.solution.pressure.maxCoeff(&peak), "kN/cm^2");
  results.add("peak_position", fine.model.pairs.position(peak, 0), "cm");
  results.add("touchdown", fine.model.pairs.position(fine.solution.contact.active.front(), 0),
              "cm");
  results.add("euler_bernoulli_touchdown", s, "cm");
  results.add("euler_bernoulli_point_force", euler_bernoulli(paper).point_force, "kN");
  results.add("timoshenko_touchdown", timoshenko(paper).touchdown, "cm");
  results.add("timoshenko_tip_force", timoshenko(paper).point_force, "kN");
}

// 7. The same beam in other units: lengths times L, forces times F.
// [units]
void change_units(const ProgramOptions& run, Results& results) {
  Table table({"units", "closed nodes", "iterations", "force [kN]", "peak pressure [kN/cm²]"});
  const SolvedScene base = solve_cantilever(paper, "q4_incompatible", 100);
  double deviation = 0;
  const std::tuple<const char*, double, double> units[] = {
      {"cm, kN", 1, 1}, {"mm, N", 10, 1e3}, {"m, Pa", 1e-2, 1e3}};
  for (const auto& [name, L, F] : units) {
    const double stress = F / (L * L);
    const BeamOnFoundation beam{50 * L, 5 * L, L, 2.1e4 * stress, 0.29, 1 * L, 3.6 * stress};
    const SolvedScene now = solve_cantilever(beam, "q4_incompatible", 100);
    const ContactState& contact = now.solution.contact;
    deviation = std::max(deviation, (contact.force / F - base.solution.contact.force).norm());
    table.row({name, std::to_string(contact.active.size()),
               std::to_string(contact.report.iterations), number(total_force(now) / F, "%.6f"),
               number(now.solution.pressure.maxCoeff() / stress, "%.6f")});
  }
  // [units]
  write_file(run.out / "units.md", table.markdown());
  results.add("total_contact_force", total_force(base), "kN");
  results.add("closed_nodes", static_cast<double>(base.solution.contact.active.size()), "-");
  deviation /= base.solution.contact.force.norm();
  if (deviation > 1e-10) throw NotSolved("units change the forces by more than 1e-10");
  results.add("units_deviation", deviation, "-", Repeats::No);
}

// 8. A linear programme, at once and in increments of the load.
// [increments]
void as_linear_programme(const ProgramOptions& /*run*/, Results& results) {
  const SolvedScene beam = solve_cantilever(paper, "q4_incompatible", 100);
  const ContactProblem& problem = beam.condensed.problem;
  const ContactState once = linear_programme(problem);
  const std::vector<ContactState> steps =
      incremental_linear_programme(problem, beam.model.pairs.initial_gap, 20);
  Index pivots = 0;
  for (const ContactState& step : steps) pivots += step.report.iterations;
  const Eigen::VectorXd& force = beam.solution.contact.force;
  const double difference =
      std::max((once.force - force).norm(), (steps.back().force - force).norm());
  // [increments]
  if (once.report.status != Status::Solved || steps.back().report.status != Status::Solved ||
      difference > 1e-9 * force.norm())
    throw NotSolved("the linear programme and the active set disagree");
  results.add("lp_pivots_once", static_cast<double>(once.report.iterations), "-");
  results.add("lp_pivots_steps", static_cast<double>(pivots), "-");
  results.add("lp_increments", static_cast<double>(steps.size()), "-");
  const Report& report = beam.solution.contact.report;
  results.add("active_sets", static_cast<double>(report.iterations), "-");
  results.add("coarse_sets", static_cast<double>(report.factorisations - report.iterations), "-");
}

// 9. The method of the paper as it is printed, on so few cells that each node can be drawn.
void as_printed(const ProgramOptions& run, Results& results) {
  const SolvedScene beam = solve_cantilever(paper, "q4_incompatible", 50);
  const PrintedMethod printed = printed_method(beam.condensed.problem);
  for (const Index cells : {50, 100, 200}) {
    const SolvedScene now = solve_cantilever(paper, "q4_incompatible", cells);
    if (!solved_in_one_step(now.condensed.problem, now.solution.contact))
      throw NotSolved("the printed method does not end at the solution after one step");
    if (now.condensed.problem.compliance.minCoeff() < 0)
      throw NotSolved("a force that lifts a node of the beam presses another one down");
  }
  const BodyModel& body = beam.model.bodies[0];
  const Eigen::VectorXd x = beam.model.pairs.position.col(0);
  write_printed_method(run.out / "fig_6_5", printed, x);
  write_file(run.out / "fig_6_1.csv",  // the mesh before loading
             deformed_cells_csv(body.mesh, beam.solution.displacements[0],
                                Eigen::VectorXd::Zero(body.mesh.n_cells()), 0));
  add_counts(results, printed);
  results.add("printed_first", x(printed.group.front()), "cm");
  results.add("printed_deepest", -beam.condensed.problem.free_gap.minCoeff(), "cm");
}

// 10. The order of elimination, and what the way of the rows of A costs, on a square body and on the beam.
void elimination(const ProgramOptions& run, Results& results) {
  Ledger ledger;
  Scene square = cantilever(paper, "q4", 100);
  square.bodies[0].mesh = block("block", {0, 0}, {paper.height, paper.height}, 24, 24);
  const Model body = build(square, ledger);
  const ch06::DrawnTree tree = ch06::drawn_tree(body);
  write_file(run.out / "fig_6_6.csv", ch06::drawn_nodes(tree, body).csv());
  write_file(run.out / "fig_6_6_tree.csv", ch06::drawn_branches(tree).csv());
  results.add("price_square", 100 * ch06::price_of_compliance(tree, body), "%");
  for (const Index cells : {100, 400}) {
    const Model beam = build(cantilever(paper, "q4", cells), ledger);
    results.add(text("price_beam_", cells),
                100 * ch06::price_of_compliance(ch06::drawn_tree(beam), beam), "%");
  }
}

// 11. What total_force_2d is the limit of.
void finest_mesh(const ProgramOptions& /*run*/, Results& results) {
  const SolvedScene beam = solve_cantilever(paper, "q4_incompatible", 800);
  results.add("fine_800", total_force(beam), "kN", Repeats::No);
}

Status chapter(const ProgramOptions& run) {
  Results results("ch06");
  std::vector<std::pair<const char*, void (*)(const ProgramOptions&, Results&)>> studies = {
      {"load history", load_history},
      {"four elements", compare_elements},
      {"contact pressure", contact_pressure},
      {"units", change_units},
      {"linear programme", as_linear_programme},
      {"the printed method", as_printed},
      {"elimination", elimination}};
  if (run.full) studies.push_back({"800 x 80 cells", finest_mesh});
  for (std::size_t k = 0; k < studies.size(); ++k) {
    if (run.full)
      std::cerr << "ch06: study " << k + 1 << " of " << studies.size() << ", " << studies[k].first
                << '\n';
    studies[k].second(run, results);
  }
  results.headline("total_contact_force", total_force_2d, "limit of finer meshes");
  results.print();
  results.write(run.out);
  return Status::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch06", "A cantilever on a rigid foundation", SIGNORINI_CHAPTER_OUT,
                                argc, argv, chapter);
}

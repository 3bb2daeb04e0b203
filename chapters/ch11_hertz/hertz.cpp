// Chapter 11 - Hertz: an elastic cylinder on an elastic plate (Lin et al., sec. 3.1, eq. 43).
// Run:  make ch11     Reads: nothing     Writes: ch11.results, table2.md, grid.md, solvers.md, operators.md,
//       printed.md, refinement.md, shear.md, facing.md, plates.md, normals.md, fig_11_*.csv
#include "below_contact.hpp"
#include "drawings.hpp"
#include "hertz_run.hpp"
#include "printed_study.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/scene/bodies.hpp"

namespace {

using namespace signorini;
using Eigen::Index;

const double pi = std::acos(-1.0);
const HertzCase example;
const double b = hertz_half_width(example.theory());
const double q0 = hertz_peak_pressure(example.theory());

std::string percent(double x) { return number(x, "%+.3f"); }

// 1. Table 2 again: every row with the load that an ellipse of its b and q0 carries.
void second_table(const ProgramOptions& run, Results& results, const HertzRun& ours) {
  Table table({"", "b [mm]", "error [%]", "q0 [MPa]", "error [%]", "πbq0/2 [N/mm]", "error [%]"});
  const auto row = [&](const std::string& name, double width, double peak) {
    const double load = pi * width * peak / 2;
    table.row({name, number(width, "%.5f"), percent(100 * (width / b - 1)), number(peak, "%.4f"),
               percent(100 * (peak / q0 - 1)), number(load, "%.2f"),
               percent(100 * (load / example.load - 1))});
  };
  row("(43)", b, q0);
  row("(43) as printed", 1.08, 24.6219);
  row("this chapter", ours.half_width, ours.fit.peak_pressure);
  row("the paper", 1.09957, 23.8437);
  row("its ABAQUS", 1.1178, 23.4287);
  write_file(run.out / "table2.md", table.markdown());
  results.add("b", b, "mm");
  results.add("q0", q0, "MPa");
  results.add("q0_with_3_14", q0 * std::sqrt(pi / 3.14), "MPa");
  results.add("b_with_3_14", b * std::sqrt(pi / 3.14), "mm");
  results.add("modulus", example.theory().modulus, "MPa");
  results.add("q_fit_error", ours.q_error, "%");
  results.add("b_m2_error", ours.b_error, "%");
  results.add("nodes", static_cast<double>(count_nodes(ours.run.model.bodies)), "-");
  const double sum = std::accumulate(ours.force.begin(), ours.force.end(), 0.0);
  results.add("resultant", 2 * sum, "N/mm");
}

// 2. Three ways to read b: the last closed node follows the grid, the other two do not.
void reading_the_width(const ProgramOptions& run) {
  Table table({"core [mm]", "nodes on b", "last closed node", "fit", "second moment", "q0, fit"});
  for (const double core : {1.3, 1.35, 1.4, 1.45, 1.5, 1.55, 1.6}) {
    HertzCase now;
    now.mesh.core = core;
    const HertzRun out = solve_hertz(now);
    table.row({number(core, "%.2f"), number(b / out.x[1], "%.1f"),
               percent(100 * (out.last_closed / b - 1)),
               percent(100 * (out.fit.half_width / b - 1)), percent(out.b_error),
               percent(out.q_error)});
  }
  write_file(run.out / "grid.md", table.markdown());
}

// 3. Iterations, on the example and in 20 000 nodes.
void iterations(const ProgramOptions& run, Results& results, const HertzRun& fine) {
  Table table({"solver", "1.4k nodes", "20k nodes"});
  for (const char* name : {"fischer_burmeister", "primal_dual_active_set", "quasi_active_set"}) {
    HertzCase now;
    now.solver = name;
    const Solution large = solve(fine.run.model, fine.run.condensed, name, {});
    require_solved(large, name);
    const HertzRun small = solve_hertz(now);
    if (now.solver == "fischer_burmeister") study_as_printed(run.out, results, small);
    table.row({name, std::to_string(small.run.solution.contact.report.iterations),
               std::to_string(large.contact.report.iterations)});
  }
  write_file(run.out / "solvers.md", table.markdown());
}

// 4. Three operators, the forces of Gauss points lumped to nodes: where meshes match and where not.
void operators(const ProgramOptions& run) {
  Table table({"operator", "meshes", "pairs", "q0 [%]", "b [%]", "rms p [%]"});
  for (const bool match : {true, false})
    for (const auto& [name, points] : {std::pair("mortar", 0),
                                       {"node_to_segment", 0},
                                       {"gauss_points", 1},
                                       {"gauss_points", 2}}) {
      HertzCase now = match ? example : not_matching();
      now.gap_operator = name;
      now.points = points;
      now.solver = "quasi_active_set";  // takes gaps that depend on each other
      const HertzRun out = solve_hertz(now);
      table.row({points > 0 ? text(name, ", ", points) : name, match ? "match" : "do not",
                 std::to_string(out.run.model.pairs.weight.size()), percent(out.q_error),
                 percent(out.b_error), number(pressure_error(out), "%.2f")});
    }
  write_file(run.out / "operators.md", table.markdown());
}

// 5. Finer meshes; and the largest shear below the surface against M'Ewen, also for a load that makes
//    the contact ten times narrower.
void refinement(const ProgramOptions& run, const std::vector<HertzRun>& runs) {
  Table table(
      {"nodes", "edges on b", "iterations", "q0 [%]", "b [%]", "rms p [%]", "sinks by [mm]"});
  Table shear({"nodes", "P [N/mm]", "body", "depth/b", "error [%]", "shear/q0", "error [%]"});
  const auto row = [&shear](const HertzRun& out) {
    const LargestShear exact = hertz_largest_shear(out.now.theory());
    for (const std::size_t body : {0, 1}) {
      const LargestShear got = along_axis(out.run, body).largest;
      shear.row({std::to_string(count_nodes(out.run.model.bodies)), number(out.now.load, "%.4g"),
                 out.run.model.bodies[body].mesh.name,
                 number(got.depth / hertz_half_width(out.now.theory()), "%.4f"),
                 number(100 * (got.depth / exact.depth - 1), "%+.2f"),
                 number(got.stress / hertz_peak_pressure(out.now.theory()), "%.4f"),
                 number(100 * (got.stress / exact.stress - 1), "%+.2f")});
    }
  };
  for (const HertzRun& out : runs) {
    table.row({std::to_string(count_nodes(out.run.model.bodies)), number(b / out.x[1], "%.1f"),
               std::to_string(out.run.solution.contact.report.iterations), percent(out.q_error),
               percent(out.b_error), number(pressure_error(out), "%.3f"),
               number(sinking(out.run, 1), "%.5f")});
    row(out);
  }
  row(solve_hertz(narrow()));
  write_file(run.out / "refinement.md", table.markdown());
  write_file(run.out / "shear.md", shear.markdown());
}

// 6. The two nodes that touch first, and what the size of the plate does to them.
void facing_nodes(const ProgramOptions& run, const HertzRun& ours) {
  Table facing({"", "node of the disc [mm]", "node of the plate [mm]", "difference [mm]"});
  const double disc = sinking(ours.run, 0), plate = sinking(ours.run, 1);
  if (std::abs(disc - plate) > 1e-12) throw NotSolved("the nodes at x = 0 part");
  facing.row({"this chapter", number(disc, "%.6f"), number(plate, "%.6f"), "below 1e-12"});
  facing.row({"the paper", "0.0291", "0.0291", "0"});
  facing.row({"its ABAQUS", "0.0293163", "0.0289943", "0.000322"});
  write_file(run.out / "facing.md", facing.markdown());
  Table plates({"half width [mm]", "depth [mm]", "sinks by [mm]", "q0 [%]", "b [%]"});
  for (const auto& [width, depth] : {std::pair(95, 95), {190, 95}, {95, 190}, {190, 190}}) {
    HertzCase now;
    now.mesh.plate = {width, depth};
    const HertzRun out = solve_hertz(now);
    plates.row({std::to_string(width), std::to_string(depth), number(sinking(out.run, 1), "%.4f"),
                percent(out.q_error), percent(out.b_error)});
  }
  write_file(run.out / "plates.md", plates.markdown());
}

// 7. Whose normal? The roles change places on three pairs of bodies.
void whose_normal(const ProgramOptions& run) {
  Table table({"disc, E [MPa]", "plate, E [MPa]", "disc is source [%]", "plate is source [%]",
               "difference", "(c)"});
  for (const auto& [disc, plate] : {std::pair(4e3, 4e3), {4e3, 4e9}, {4e9, 4e3}}) {
    HertzCase now;
    now.disc_modulus = disc;
    now.plate_modulus = plate;
    now.mesh.core *= hertz_half_width(now.theory()) / b;
    const double flat = solve_hertz(now).b_error;
    now.plate_is_source = true;
    const double round = solve_hertz(now).b_error;
    table.row({number(disc, "%.0e"), number(plate, "%.0e"), percent(flat), percent(round),
               percent(round - flat), percent(radial_normals(now))});
  }
  write_file(run.out / "normals.md", table.markdown());
}

Status chapter(const ProgramOptions& run) {
  Results results("ch11");
  std::vector<HertzRun> runs;
  for (const HertzCase& now : {example, finer(32, 24, 30), finer(64, 48, 60)})
    runs.push_back(solve_hertz(now));
  second_table(run, results, runs[0]);
  reading_the_width(run);
  iterations(run, results, runs[2]);
  operators(run);
  refinement(run, runs);
  facing_nodes(run, runs[0]);
  draw(run.out, runs[0]);
  whose_normal(run);
  results.headline("b_m2_error", 0, "closed form, half-planes");
  results.print();
  results.write(run.out);
  return Status::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch11", "Hertz: an elastic cylinder on an elastic plate",
                                SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}

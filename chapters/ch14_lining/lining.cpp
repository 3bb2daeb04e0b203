// Chapter 14 - A lining in a tunnel (Lin et al., sec. 3.4): when the gap closes, and what that proves.
// Run:  make ch14     Reads: nothing     Writes: ch14.results, elements.md,
//                              fig_14_2*.csv, ch14.vtu
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

#include "addons/vtu/vtu.hpp"
#include "readings.hpp"
#include "rings.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;
using namespace ch14;

// Loads from nothing to the paper's: figure 14.2.
void load_history(const std::filesystem::path& out, Results& results) {
  Table exact({"p", "gap", "pressure"});
  Table mesh({"p", "gap", "pressure"});
  Rings rings;
  for (const double p : {0., 20., 40., 60., 72., 73., 80., 100., 120., 140., 160., 180.}) {
    rings.pressure = p;
    const SolvedScene now = run_of(rings);
    const double gap = now.solution.contact.gap.mean();
    mesh.row({p, std::abs(gap) < 1e-12 ? 0 : gap, now.solution.pressure.mean()});
    if (p != 72 && p != 73) continue;
    results.add(text("closed_at_", p), static_cast<double>(now.solution.contact.active().size()),
                "-");
    results.add(text("p_at_", p), now.solution.pressure.mean(), "MPa");
  }
  for (const double p : {0., closing_pressure(closed_form(rings)), 180.}) {
    rings.pressure = p;
    const NestedRings now = closed_form(rings);
    const NestedPressure on = nested_pressure(now);
    const double closed = ring_displacement(now.inner, on.inner, now.inner.outer_radius) -
                          ring_displacement(now.outer, on.outer, now.outer.inner_radius);
    exact.row({p, std::max(ring_clearance(now) - closed, 0.), on.inner.outside});
  }
  write_file(out / "fig_14_2.csv", exact.csv());
  write_file(out / "fig_14_2_mesh.csv", mesh.csv());
}

// Four elements on the paper's mesh.
void compare_elements(const ProgramOptions& run, Results& results) {
  const double u_exact = inner_rim(closed_form(paper));
  const double p_exact = nested_pressure(closed_form(paper)).inner.outside;
  Table table({"element", "u(a) [cm]", "deviation [%]", "contact pressure [MPa]", "deviation [%]"});
  for (const char* name : {"q4", "q4_bbar", "q4_incompatible", "q8"}) {
    Rings rings;
    rings.element = name;
    const SolvedScene now = run_of(rings);
    const double u = inner_rim(now).mean(), p = now.solution.pressure.mean();
    table.row({name, number(u, "%.6f"), number(percent(u, u_exact), "%.4f"), number(p, "%.4f"),
               number(percent(p, p_exact), "%.4f")});
    results.add(text("u_", name), u, "cm");
    results.add(text("p_", name), p, "MPa");
  }
  std::cout << table.markdown();
  write_file(run.out / "elements.md", table.markdown());
}

// How far node 10 moves towards node 80, along x and y.
Eigen::RowVector2d closing(const SolvedScene& now, double angle) {
  const Index node_10 = nearest(now.model.bodies[0].mesh, 68, angle);
  const Index node_80 = nearest(now.model.bodies[1].mesh, 68.15, angle);
  return now.solution.displacements[0].row(node_10) - now.solution.displacements[1].row(node_80);
}

// What the pair of nodes of the paper's figure 24 says, and what it does not.
void paper_mesh(const ProgramOptions& run, Results& results) {
  const SolvedScene now = run_of(paper);
  const double angle = 4 * quarter_turn / 9;  // 40 degrees
  const Eigen::RowVector2d moved = closing(now, angle);
  results.add("pair_x", moved.x(), "cm");
  results.add("pair_y", moved.y(), "cm");
  results.add("pair_total", moved.norm(), "cm");
  results.add("pair_printed_before", std::hypot(0.1149, 0.0965), "cm");
  results.add("pair_printed_abaqus", std::hypot(0.1157, 0.0971), "cm");
  results.add("pair_overlap", moved.norm() - 0.15, "cm", Repeats::No);
  const double spread = now.solution.pressure.maxCoeff() / now.solution.pressure.minCoeff() - 1;
  results.add("pressure_spread", spread, "-", Repeats::No);
  results.add("iterations", double(now.solution.contact.report.iterations), "-");
  Rings overlapping;  // what an overlap that is left does to the displacement: a gap as much larger
  overlapping.radii[2] += 0.00104;
  overlapping.radii[3] += 0.00104;
  results.add("u_of_overlap_percent",
              percent(inner_rim(closed_form(overlapping)), inner_rim(closed_form(paper))), "%");
  write_vtu(run.out / "ch14.vtu", now.model, now.solution);
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch14");
  load_history(run.out, results);
  compare_elements(run, results);
  paper_mesh(run, results);
  results.headline("p_q4_incompatible", nested_pressure(closed_form(paper)).inner.outside,
                   "Lame, two rings");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch14", "A lining in a tunnel", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}

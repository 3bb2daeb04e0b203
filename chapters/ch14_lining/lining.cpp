// Chapter 14 - A lining in a tunnel (Lin et al., sec. 3.4, figures 20 to 24).
// Run:  make ch14     Reads: nothing     Writes: ch14.results, radii.md, elements.md, refined.md,
//                              turned.md, fig_14_1*.csv to fig_14_5*.csv, ch14.vtu
#include "figures.hpp"
#include "pictures.hpp"
#include "readings.hpp"
#include "rings.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/mesh/reshape.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/shown.hpp"
#include "signorini/report/vtu.hpp"

namespace {

using namespace signorini;
using namespace ch14;

const Rings paper;
const double u_paper = 0.2897, u_abaqus = 0.290828;  // the paper's largest displacements [cm]

double percent(double value, double exact) { return 100 * (value / exact - 1); }

// 1. Closed form: what closes the gap, what it bears then, and that the radii cannot be read off u.
// [radii]
void closed_forms(const ProgramOptions& run, Results& results) {
  Table table(
      {"a", "b", "c", "d", "u(a) [cm]", "closing pressure [MPa]", "contact pressure [MPa]"});
  for (const std::array<double, 4>& radii :
       {paper.radii, {70, 79, 79.15, 97}, {100, 127, 127.15, 154}}) {
    Rings rings;
    rings.radii = radii;
    const NestedRings exact = closed_form(rings);
    std::vector<std::string> row;
    for (const double r : radii) row.push_back(number(r));
    row.push_back(number(inner_rim(exact), "%.4f"));
    row.push_back(number(closing_pressure(exact), "%.1f"));
    row.push_back(number(nested_pressure(exact).inner.outside, "%.1f"));
    table.row(row);
  }
  int same = 0, all = 0;                    // walls from a twentieth to half of the inner radius
  double least = paper.pressure, most = 0;  // contact pressures of the same
  for (int a = 20; a <= 120; ++a)
    for (int b = a + (a + 19) / 20; b <= a + a / 2; ++b)
      for (int d = b + (a + 19) / 20; d <= b + a / 2; ++d, ++all) {
        Rings rings;
        rings.radii = {double(a), double(b), b + 0.15, double(d)};
        const double u = inner_rim(closed_form(rings));
        if (std::abs(percent(u, u_abaqus)) >= percent(u_abaqus, u_paper)) continue;
        const double p = nested_pressure(closed_form(rings)).inner.outside;
        least = std::min(least, p), most = std::max(most, p), ++same;
      }
  // [radii]
  write_file(run.out / "radii.md", table.markdown());
  results.add("radii_same", same, "-");
  results.add("radii_all", all, "-");
  results.add("radii_p_least", least, "MPa");
  results.add("radii_p_most", most, "MPa");
  const NestedRings forces = closed_form(paper);
  const NestedRings books = closed_form(paper, Meeting::EqualPressure);
  results.add("closing_pressure", closing_pressure(forces), "MPa");
  results.add("p_exact", nested_pressure(forces).inner.outside, "MPa");
  results.add("p_exact_books", nested_pressure(books).inner.outside, "MPa");
  results.add("p_exact_rock", nested_pressure(forces).outer.inside, "MPa");
  results.add("u_exact", inner_rim(forces), "cm");
  results.add("u_over_paper", percent(inner_rim(forces), u_paper), "%");
  results.add("u_over_abaqus", percent(inner_rim(forces), u_abaqus), "%");
  results.add("hoop_lining", ring_stress(forces.inner, nested_pressure(forces).inner, 60).hoop,
              "MPa");
  results.add("hoop_rock", ring_stress(forces.outer, nested_pressure(forces).outer, 68.15).hoop,
              "MPa");
  results.add("u_exact_books", inner_rim(books), "cm");
  results.add("u_difference_percent", percent(u_abaqus, u_paper), "%");
}

// 2. The paper's mesh: four elements, and the pair of nodes of figure 24.
// [elements]
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
  // [elements]
  write_file(run.out / "elements.md", table.markdown());
}

// [pair]
Eigen::RowVector2d closing(const SolvedScene& now, double angle) {
  const Index node_10 = nearest(now.model.bodies[0].mesh, 68, angle);
  const Index node_80 = nearest(now.model.bodies[1].mesh, 68.15, angle);
  return now.solution.displacements[0].row(node_10) - now.solution.displacements[1].row(node_80);
}
// [pair]

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
  if (std::abs(moved.norm() - 0.15) > 1e-12) throw NotSolved("nodes 10 and 80 do not meet");
  if (spread > 1e-9) throw NotSolved("the pressure is not uniform to 1e-9");
  results.add("pressure_spread", spread, "-", Repeats::No);
  results.add("iterations", double(now.solution.contact.report.iterations), "-");
  Rings overlapping;  // what an overlap that is left does to the displacement: a gap as much larger
  overlapping.radii[2] += 0.00104;
  overlapping.radii[3] += 0.00104;
  results.add("u_of_overlap_percent",
              percent(inner_rim(closed_form(overlapping)), inner_rim(closed_form(paper))), "%");
  sketch(run.out, now);
  fields(run.out, now);
  meeting_rims(run.out, now);
  results.add("stress_worst", stresses_through_walls(run.out, now), "MPa");
  write_vtu(run.out / "ch14.vtu", now.model, now.solution);
}

// 3. One force, three pressures; then meshes that are twice as fine, again and again.
// [refine]
void refine(const ProgramOptions& run, Results& results) {
  const double u_exact = inner_rim(closed_form(paper));
  const double p_exact = nested_pressure(closed_form(paper)).inner.outside;
  Table table({"cells per ring", "by the arc", "by the chords", "on the chords", "u(a)"});
  for (const Index times : {1, 2, 4, 8}) {
    Rings rings;
    rings.cells_angle *= times;
    rings.cells_radius *= times;
    const SolvedScene mortar = run_of(rings);
    rings.gap_operator = "node_to_segment";
    const double chords = run_of(rings).solution.pressure.mean();
    const double half_cell = quarter_turn / 2 / double(rings.cells_angle);
    const double arc = chords * std::sin(half_cell) / half_cell;
    table.row({text(rings.cells_angle, " x ", rings.cells_radius),
               number(percent(arc, p_exact), "%.4f"), number(percent(chords, p_exact), "%.4f"),
               number(percent(mortar.solution.pressure.mean(), p_exact), "%.5f"),
               number(percent(inner_rim(mortar).mean(), u_exact), "%.5f")});
    if (times == 1) results.add("p_by_arc", arc, "MPa");
    if (times == 1) results.add("p_by_chords", chords, "MPa");
  }
  // [refine]
  write_file(run.out / "refined.md", table.markdown());
}

// 4. Without a gap, and with less than none.
// [gaps]
void other_gaps(Results& results) {
  Rings none;
  none.radii = {60, 68, 68, 76};
  const Scene scene = scene_of(none);
  const SolvedScene two = shown(scene, "rings without gap");
  Scene glued;
  glued.bodies[0] = scene.bodies[0];
  glued.bodies[0].mesh = joined(scene.bodies[0].mesh, "outer", scene.bodies[1].mesh, "inner");
  const SolvedScene one = solved(glued, "one ring");
  const double difference =
      (cell_stresses(one, 0).hoop.head(45) - cell_stresses(two, 0).hoop).norm();
  Rings fit;
  fit.radii = {60, 68.05, 68, 76};
  fit.pressure = 0;
  const SolvedScene pressed = run_of(fit);
  // [gaps]
  if (difference > 1e-9 * none.pressure) throw NotSolved("two rings without gap are not one");
  results.add("p_no_gap", two.solution.pressure.mean(), "MPa");
  results.add("p_no_gap_exact", nested_pressure(closed_form(none)).inner.outside, "MPa");
  const NestedRings exact = closed_form(fit);
  const NestedPressure on = nested_pressure(exact);
  results.add("p_fit", pressed.solution.pressure.mean(), "MPa");
  results.add("p_fit_exact", on.inner.outside, "MPa");
  results.add("hoop_fit_lining", ring_stress(exact.inner, on.inner, 60).hoop, "MPa");
  results.add("hoop_fit_rock", ring_stress(exact.outer, on.outer, 68).hoop, "MPa");
}

// 5. The rock's mesh turned by half a cell, and either side as the source.
// [turn]
void turned_meshes(const ProgramOptions& run, Results& results) {
  Table table(
      {"element", "cells", "operator", "source", "first gaps [cm]", "u(a) [cm]", "pressure [MPa]"});
  const auto range = [](const Eigen::VectorXd& x, const char* format) {
    return number(x.minCoeff(), format) + " to " + number(x.maxCoeff(), format);
  };
  Rings rings;
  rings.turn = 0.5;
  for (const auto& [element, cells] :
       {std::pair{"q4_incompatible", 9}, {"q4_incompatible", 36}, {"q8", 9}})
    for (const char* gap_operator : {"node_to_segment", "gauss_points", "mortar"})
      for (const char* source : {"lining", "rock"}) {
        rings.element = element;
        rings.cells_angle = cells;
        rings.gap_operator = gap_operator;
        Scene scene = scene_of(rings);
        ContactSpec& contact = scene.contacts[0];
        if (contact.source.body != source)
          std::swap(contact.source, std::get<Side>(contact.target));
        const SolvedScene now = solved(scene, "the turned lining");
        table.row({element, number(cells), gap_operator, source,
                   range(now.model.pairs.initial_gap, "%.3f"), range(inner_rim(now), "%.4f"),
                   range(now.solution.pressure, "%.0f")});
      }
  // [turn]
  write_file(run.out / "turned.md", table.markdown());
  const double half_cell = quarter_turn / 18;
  results.add("sagitta", 68.15 * (1 - std::cos(half_cell)), "cm");
  results.add("gap_over_chord", 68.15 * std::cos(half_cell) - 68, "cm");
}

Status chapter(const ProgramOptions& run) {
  Results results("ch14");
  closed_forms(run, results);
  load_history(run.out, results);
  compare_elements(run, results);
  paper_mesh(run, results);
  refine(run, results);
  other_gaps(results);
  turned_meshes(run, results);
  results.headline("p_q4_incompatible", results.value("p_exact"), "Lame, two rings");
  results.print();
  results.write(run.out);
  return Status::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch14", "A lining in a tunnel", SIGNORINI_CHAPTER_OUT, argc, argv,
                                chapter);
}

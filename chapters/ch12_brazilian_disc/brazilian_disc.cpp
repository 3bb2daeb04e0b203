// Chapter 12 - The Brazilian disc (Lin et al., sec. 3.2, equations (44) and (45)).
// Run:  make ch12     Reads: disc.msh    Writes: ch12.results, meshes.md, arcs.md, cuts.md, ch12.vtu,
//                       data of figures 12.1 to 12.5
#include <cmath>

#include "drawings.hpp"
#include "from_gmsh.hpp"
#include "references.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/vtu.hpp"

namespace {

using namespace ch12;
using Eigen::Vector3d;

// 1. Data and scene are in scene.hpp. The field (45): nothing is left on the rim, neither a traction nor a stress along it.
// [rim]
void check_field(Results& results) {
  double left = 0;
  for (int degree = 1; degree < 180; ++degree) {
    const double theta = degree * std::acos(-1.0) / 180;  // from the upper load
    const Vector3d stress =
        line_loaded_disc_stress(lines, R * std::sin(theta), R * std::cos(theta));
    left = std::max(left, stress.cwiseAbs().maxCoeff());
  }
  if (left > 1e-11 * strength) throw NotSolved("the rim of the field (45) is not free");
  // [rim]
  results.add("rim_stress", left / strength, "-", Repeats::No);
  results.add("lines_along", line_loaded_disc_stress(lines, 0, 0)[1], "MPa");
  const double distance = std::hypot(R, R / 2), sine = R / 2 / distance, cosine = R / distance;
  results.add("shear_with_plus", 4 * P / std::acos(-1.0) * sine * cosine * cosine / distance,
              "MPa");
}

// 2. Hondros' arcs: what a width of the load costs in the middle.
void compare_arcs(const ProgramOptions& run, Results& results) {
  Table table({"2α [°]", "chord [mm]", "σx / strength", "with p = P/(2Rα)"});
  for (const double degrees : {2., 5., 10., 15., 20., 30.}) {
    const double alpha = degrees / 2 * std::acos(-1.0) / 180;
    const double ratio = arc_loaded_disc_stress(lines, alpha, 0, 0)[0] / strength;
    table.row({number(degrees, "%.0f"), number(2 * R * std::sin(alpha), "%.2f"),
               number(ratio, "%.4f"), number(ratio * std::sin(alpha) / alpha, "%.4f")});
  }
  write_file(run.out / "arcs.md", table.markdown());
  results.add("arc_of_contact", 2 * b / R * 180 / std::acos(-1.0), "degree");
  // [moment]
  const double narrower = std::sqrt(0.75) * b / R;  // the second moment of an ellipse on 2 b
  double apart = 0;
  for (double depth = 2 * b; depth < R; depth += 0.1)
    apart = std::max(apart, std::abs(arc_loaded_disc_stress(lines, narrower, 0, depth - R)[0] -
                                     exact_across(depth)));
  // [moment]
  results.add("arc_of_equal_moment", 100 * apart / strength, "%");
  results.add("arc_as_wide_at_2b",
              100 * (arc_loaded_disc_stress(lines, b / R, 0, 2 * b - R)[0] - exact_across(2 * b)) /
                  strength,
              "%");
  results.add("arc_middle", arc_loaded_disc_stress(lines, b / R, 0, 0)[0], "MPa");
}

// 3. Refinement of both meshes.
// [meshes]
void refine(const ProgramOptions& run) {
  Table table({"fine at", "nodes", "middle [%]", "against (44) [%]", "axis [%]", "turns at [mm]"});
  for (const Division& division : {for_middle, for_axis})
    for (const double finer : {0.5, 1., 2.}) {
      if (division.grading > 1 && finer > 1) continue;  // 40000 nodes
      const SolvedScene now = solve_disc(division, finer);
      const double across = middle(now)[0];
      table.row({division.grading > 1 ? "poles" : "middle", std::to_string(nodes_of(now)),
                 number(100 * (across / exact_across(R) - 1), "%+.4f"),
                 number(100 * (across / strength - 1), "%+.4f"),
                 number(100 * axis_error(now), "%.2f"),
                 number(sign_change(diameter_of(now)), "%.3f")});
    }
  // [meshes]
  write_file(run.out / "meshes.md", table.markdown());
}

// 4. The loaded diameter, for figure 12.5.
void along_axis(const ProgramOptions& run, const SolvedScene& now, Results& results) {
  const Diameter axis = diameter_of(now);
  Table nodes({"depth", "across"});
  for (Index k = 0; k < axis.depth.size() && axis.depth(k) <= R; ++k)
    if (axis.depth(k) > 0.4) nodes.row({axis.depth(k), axis.stress(k, 0)});
  Table curves({"depth", "plates", "arcs", "lines"});
  for (int k = 0; k <= 200; ++k) {
    const double depth = 0.4 * std::pow(R / 0.4, k / 200.);
    curves.row({depth, exact_across(depth), arc_loaded_disc_stress(lines, b / R, 0, depth - R)[0],
                line_loaded_disc_stress(lines, 0, depth - R)[0]});
  }
  write_file(run.out / "fig_12_5.csv", curves.csv());
  write_file(run.out / "fig_12_5_nodes.csv", nodes.csv("rel 1e-6 abs 1e-7"));
  results.add("axis_error", 100 * axis_error(now), "%");
  results.add("axis_nodes", static_cast<double>(nodes_of(now)), "-");
  results.add("sign_change", sign_change(axis), "mm");
  compare_references(axis, results);
}

// 5. Every cut carries P, and the two contacts are alike.
// [cuts]
void balance(const ProgramOptions& run, const SolvedScene& now, Results& results) {
  Table table({"cut at y [mm]", "half of the force [N/mm]"});
  for (const double height : {1.5, 5., 25., 50.1, 75., 98.}) {
    const double force = force_across(now, height);
    if (std::abs(force - P / 2) > 1e-10 * P) throw NotSolved("a cut does not carry P");
    table.row({number(height, "%.1f"), number(force, "%.6f")});
  }
  // [cuts]
  write_file(run.out / "cuts.md", table.markdown());
  const Contact low = contact_of(now, false), high = contact_of(now, true);
  Table nodes({"x", "lower", "upper"});
  Table curve({"x", "hertz"});
  double difference = 0;
  for (std::size_t k = 0; k < low.x.size(); ++k) {
    difference = std::max(difference, std::abs(low.pressure[k] - high.pressure[k]));
    if (low.x[k] < 1.3) nodes.row({low.x[k], low.pressure[k], high.pressure[k]});
  }
  for (int k = 0; k <= 500; ++k) curve.row({0.0025 * k, hertz_pressure(plate, 0.0025 * k)});
  write_file(run.out / "fig_12_4_nodes.csv", nodes.csv("rel 1e-6 abs 1e-6"));
  write_file(run.out / "fig_12_4.csv", curve.csv());
  const double q0 = hertz_peak_pressure(plate);
  results.add("half_width", b, "mm");
  results.add("peak_pressure", q0, "MPa");
  results.add("contact_difference", 100 * difference / q0, "%");
  results.add("lower_peak_error", 100 * (fit_hertz(low.x, low.pressure).peak_pressure / q0 - 1),
              "%");
  results.add("upper_peak_error", 100 * (fit_hertz(high.x, high.pressure).peak_pressure / q0 - 1),
              "%");
  results.add("lower_width_error", 100 * (half_width_of_forces(low.x, low.force) / b - 1), "%");
  results.add("upper_width_error", 100 * (half_width_of_forces(high.x, high.force) / b - 1), "%");
  results.add("iterations", static_cast<double>(now.solution.contact.report.iterations), "-");
  results.add("pairs", static_cast<double>(now.model.pairs.weight.size()), "-");
  results.add("closed_pairs", static_cast<double>(now.solution.contact.active.size()), "-");
  results.add("sinks", -now.solution.displacements[2].col(1).maxCoeff(), "mm");
}

// 6. The middle of the disc, where (44) is read.
void strength_test(const SolvedScene& now, Results& results) {
  const Vector3d stress = middle(now);
  results.add("strength", strength, "MPa");
  results.add("strength_with_3_14", 2 * P / (3.14 * 2 * R), "MPa");
  results.add("middle", stress[0], "MPa");
  results.add("middle_plates", exact_across(R), "MPa");
  results.add("middle_plates_error", 100 * (stress[0] / exact_across(R) - 1), "%");
  results.add("middle_lines_error", 100 * (stress[0] / strength - 1), "%");
  results.add("plates_against_lines", 100 * (exact_across(R) / strength - 1), "%");
  results.add("middle_nodes", static_cast<double>(nodes_of(now)), "-");
}

// 7. Pictures, in drawings.hpp; and the same with a disc from Gmsh, in from_gmsh.hpp.
Status chapter(const ProgramOptions& run) {
  Results results("ch12");
  check_field(results);
  compare_arcs(run, results);
  strength_test(solve_disc(for_middle), results);
  const SolvedScene fine = solve_disc(for_axis);
  if (fine.solution.certificate.worst() > 1e-12) throw NotSolved("the certificate exceeds 1e-12");
  along_axis(run, fine, results);
  balance(run, fine, results);
  refine(run);
  write_vtu(run.out / "ch12.vtu", fine.model, fine.solution);
  draw(run.out);
  solve_file(std::filesystem::path(SIGNORINI_CHAPTER_DATA) / "disc.msh", results);
  results.headline("middle", exact_across(R), "disc between plates under the pressure of Hertz");
  results.print();
  results.write(run.out);
  return Status::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch12", "The Brazilian disc", SIGNORINI_CHAPTER_OUT, argc, argv,
                                chapter);
}

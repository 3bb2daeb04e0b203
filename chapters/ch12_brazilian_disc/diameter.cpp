// Chapter 12 - The loaded diameter, by the mesh and by three references.
// Run:  make ch12     Reads: nothing     Writes: ch12_diameter.results, fig_12_5.csv, fig_12_5_nodes.csv
#include <cmath>

#include "reading.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch12;

// 1. Stress across it at the nodes, between plates, under arcs as wide as the contact, and under lines.
Diameter along_axis(const ProgramOptions& run, const SolvedScene& now, Results& results) {
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
  return axis;
}

// 2. Forces along the radii, with the y components of the pressure of Hertz: pairs that squeeze the disc
// across a diameter each, by Gauss' rule for an ellipse.
double radial_across(double depth) {
  const int n = 100;  // to rounding
  double sum = 0;
  for (int k = 1; k <= n; ++k) {
    const double angle = k * pi / (n + 1);
    const double share = 2.0 / (n + 1) * std::sin(angle) * std::sin(angle);
    const double sine = b / R * std::cos(angle), cosine = std::sqrt(1 - sine * sine);
    const Eigen::Vector3d stress =
        line_loaded_disc_stress({R, share * P / cosine}, -sine * (depth - R), cosine * (depth - R));
    sum += cosine * cosine * stress[0] + sine * sine * stress[1] + 2 * sine * cosine * stress[2];
  }
  return sum;
}

// Depth where the stress across turns from compression to tension [mm].
template <class Function>
double turning_depth(const Function& across) {
  double low = 2 * b, high = R;
  while (high - low > 1e-12 * R) (across((low + high) / 2) < 0 ? low : high) = (low + high) / 2;
  return low;
}

// 3. Where tension begins, and what one reference says of another.
void compare_references(const Diameter& axis, Results& results) {
  const auto plane = [](double z) { return loaded_diameter_stress(plate, R, z)[0]; };
  const auto part = [](double stress) { return 100 * stress / strength; };
  double worst = 0;
  for (Index k = 0; k < axis.depth.size(); ++k) {
    const double z = std::min(axis.depth(k), 2 * R - axis.depth(k));
    if (z >= 2 * b) worst = std::max(worst, std::abs(axis.stress(k, 0) - plane(z)));
  }
  results.add("axis_error_plane", part(worst), "%");
  results.add("plane_at_2b", part(plane(2 * b) - exact_across(2 * b)), "%");
  results.add("radial_at_2b", part(exact_across(2 * b) - radial_across(2 * b)), "%");
  results.add("sign_change_exact", turning_depth(exact_across), "mm");
  results.add("sign_change_radial", turning_depth(radial_across), "mm");
  results.add("sign_change_plane", tension_depth(plate, R), "mm");
  results.add("sign_change_estimate", std::cbrt(R * b * b / 2), "mm");
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch12_diameter");
  compare_references(along_axis(run, solve_disc(for_axis), results), results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch12_diameter", "The loaded diameter", SIGNORINI_CHAPTER_OUT, argc,
                                argv, chapter);
}

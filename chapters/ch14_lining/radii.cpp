// Chapter 14 - Can the radii be read off the displacement that the paper prints?
// Run:  make ch14     Reads: nothing     Writes: ch14_radii.results, radii.md
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include "readings.hpp"
#include "rings.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;
using namespace ch14;

const double u_paper = 0.2897, u_abaqus = 0.290828;  // the paper's largest displacements [cm]

// Three sets of radii in closed form, and all that have the displacement of ABAQUS.
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
  // [radii]
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
  std::cout << table.markdown();
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

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch14_radii");
  closed_forms(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch14_radii", "Radii and one displacement", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}

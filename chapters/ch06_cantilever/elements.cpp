// Chapter 6 - Four elements on four meshes: the total force, and how far it is from its limit.
// Run:  make ch06     Reads: nothing     Writes: ch06_elements.results, elements.md
// --full: the mesh of 800 x 80 cells, of which total_force_2d is the limit; a minute.
#include <algorithm>

#include "scene.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch06;

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch06_elements");
  const std::vector<std::string> names = {"q4", "q4_bbar", "q4_incompatible", "q8"};
  Table table({"mesh", names[0], names[1], names[2], names[3]});
  double certificate = 0;
  int certified = 0;
  double in_doubles = 0;
  for (const Index cells : {50, 100, 200, 400}) {
    std::vector<std::string> row = {text(cells, " x ", cells / 10)};
    for (const std::string& name : names) {
      const SolvedScene now = solve_cantilever(paper, name, cells);
      const double force = total_force(now);
      results.add(text("force_", name, '_', cells), force, "kN");
      row.push_back(number(force, "%.3f ") + number(100 * (force / total_force_2d - 1), "(%+.3f)"));
      certificate = std::max(certificate, now.solution.certificate.worst());
      certified += now.solution.certificate.holds(1e-12) ? 1 : 0;
      const PrimalDual rounded{now.solution.refined.displacement, {}, now.solution.refined.force};
      in_doubles = std::max(in_doubles, certify(now.model.programme, rounded).equilibrium);
    }
    table.row(row);
  }
  write_file(run.out / "elements.md", table.markdown());
  results.add("certified_runs", certified, "-");
  results.add("worst_certificate", certificate, "-", Repeats::No);
  results.add("equilibrium_in_doubles", in_doubles, "-", Repeats::No);
  if (run.full)
    results.add("fine_800", total_force(solve_cantilever(paper, "q4_incompatible", 800)), "kN",
                Repeats::No);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch06_elements", "Four elements", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}

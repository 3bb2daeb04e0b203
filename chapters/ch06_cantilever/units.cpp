// Chapter 6 - The same beam in other units: lengths times L, forces times F.
// Run:  make ch06     Reads: nothing     Writes: ch06_units.results, units.md
#include <algorithm>
#include <tuple>

#include "scene.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch06;

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch06_units");
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
    table.row({name, std::to_string(contact.active().size()),
               std::to_string(contact.report.iterations), number(total_force(now) / F, "%.6f"),
               number(now.solution.pressure.maxCoeff() / stress, "%.6f")});
  }
  write_file(run.out / "units.md", table.markdown());
  deviation /= base.solution.contact.force.norm();
  results.add("units_deviation", deviation, "-", Repeats::No);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch06_units", "Units", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}

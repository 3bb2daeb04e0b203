// Chapter 18 - A ladder of scenes, and what each rung takes.
// Run:  make ch18     Reads: nothing     Writes: ch18_ladder.results, ladder.md
#include <cmath>
#include <iostream>
#include <string>

#include "scenes.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;

// Operations of a whole solution: factor, condensation and all solves.
double work(const Ledger& ledger) {
  double sum = 0;
  for (const LedgerEntry& entry : ledger.entries())
    if (const auto found = entry.counts.find("operations"); found != entry.counts.end())
      sum += static_cast<double>(found->second);
  return sum;
}

// The ladder: every rung changes one thing, and with it rows, unknowns, or nothing but numbers.
void climb(const ProgramOptions& run, Results& results) {
  Table table(
      {"rung", "unknowns", "gaps", "slips", "amplitudes", "work [10⁶]", "largest pressure [MPa]"});
  int step = 0;
  const auto rung = [&](const std::string& name, const Scene& scene) {
    const SolvedScene now = solved(scene, name);
    const ContactProblem& problem = now.condensed.problem;
    const double q = peak_pressure(now);
    table.row({name, text(now.model.unknowns.count), text(problem.free_gap.size()),
               text(problem.free_slip.size()), text(problem.resultant.size()),
               number(1e-6 * work(now.solution.ledger), "%.0f"), number(q, "%.3f")});
    results.add(text("pressure_", ++step), q, "MPa");
    std::cout << name << '\n' << now.solution.ledger << '\n';
    return q;
  };
  const Scene pushed = on_rock(0.025);
  const Scene free = floating(with_plate(pushed));
  rung("obstacle", pushed);
  rung("two bodies", with_plate(pushed));
  const double smooth = rung("floating", free);
  const double rough = rung("friction", with_friction(free));
  rung("heat", heated(with_friction(free)));
  results.add("friction_between_equals", 1e6 * std::abs(rough / smooth - 1), "ppm", Repeats::No);
  std::cout << table.markdown();
  write_file(run.out / "ladder.md", table.markdown());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch18_ladder");
  climb(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch18_ladder", "A ladder of scenes", SIGNORINI_CHAPTER_OUT, argc,
                                argv, chapter);
}

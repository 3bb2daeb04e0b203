// Chapter 16 - Where the seconds go: every phase, over one plain solve.
// Run:  make ch16     Reads: nothing     Writes: ch16_phases.results, fig_16_4.csv
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "timed_runs.hpp"

namespace {

using namespace ch16;

// What contact adds to one plain solve of the same mesh, in seconds and in operations.
void over_plain(const std::string& name, const Runs& runs, Table& bars, Results& results) {
  double plain = median(runs, "solve");
  for (const char* phase : {"factor/ordering", "factor/symbolic", "factor/numeric"})
    plain += median(runs, phase);
  const Ledger& ledger = runs.ledger;
  const double unknowns = static_cast<double>(ledger.counted("assembly", "unknowns"));
  std::vector<std::string> row = {name, number(unknowns)};
  for (const std::string& phase : phases)
    row.push_back(number(median(runs, phase) / plain, "%.3f"));
  bars.row(std::move(row));
  results.add(text(name, "_", unknowns), operations(ledger) / runs.plain_operations, "-");
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch16_phases");
  Table bars({"scene", "unknowns", "plan ≈", "assembly ≈", "ordering ≈", "symbolic ≈", "numeric ≈",
              "condensation ≈", "contact ≈", "refinement ≈", "recovery ≈"});
  for (const Index cells : {16, 32, 64}) over_plain("hertz", several(hertz(cells)), bars, results);
  for (const Index cells : {8, 16, 32})
    over_plain("cantilever", several(cantilever(cells)), bars, results);
  write_file(run.out / "fig_16_4.csv", bars.csv());
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch16_phases", "Where the seconds go", SIGNORINI_CHAPTER_OUT, argc,
                                argv, chapter);
}

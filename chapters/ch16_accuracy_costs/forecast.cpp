// Chapter 16 - What four times the mesh will take, predicted before it runs.
// Run:  make ch16     Reads: nothing     Writes: ch16_forecast.results, fig_16_5.csv
// --full: for a mesh that is four times larger still, one minute.
// Takes longer than 5 s: ./run.sh shows its committed results.
#include <cmath>
#include <iostream>

#include "addons/prediction/prediction.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "timed_runs.hpp"

namespace {

using namespace ch16;

// 1. Four times the mesh: a phase grows as what it counts, and the plan of the larger mesh knows how much that is.
// [growth]
double growth(const std::string& phase, const Runs& small, const Prediction& large) {
  const Ledger& ledger = small.ledger;
  const auto ratio = [&](const char* where, const char* what) {
    return large.amount(where, what) / static_cast<double>(ledger.counted(where, what));
  };
  const double unknowns = ratio("assembly", "unknowns");
  if (phase == "assembly") return ratio("assembly", "stiffness entries");
  if (phase == "factor/ordering")
    return unknowns * std::log(large.amount("assembly", "unknowns")) /
           std::log(large.amount("assembly", "unknowns") / unknowns);
  if (phase == "factor/numeric") return ratio("factor/numeric", "operations");
  const double solve = ratio("condensation", "operations of one solve");
  if (phase == "refinement") return solve;
  if (phase == "condensation") {  // one solve, as fast as memory, and rows that go up the tree
    const double rows =
        (large.amount(phase, "operations") - large.amount(phase, "operations of one solve")) /
        static_cast<double>(ledger.counted(phase, "operations") -
                            ledger.counted(phase, "operations of one solve"));
    const double share = std::min(1.0, median(small, "solve") / median(small, phase));
    return share * solve + (1 - share) * rows;
  }
  if (phase == "contact") return std::pow(ratio("assembly", "rows"), 3);
  return unknowns;
}
// [growth]

// 2. In turn: whatever slows the machine down meets both meshes.
void predict_and_run(const std::string& name, const Scene& small_scene, const Scene& large_scene,
                     Table& table, Results& results) {
  const Prediction counts = predict(plan(large_scene));  // before it runs
  Runs small, large;
  for (int round = 0; round < 5; ++round) {
    for (int k = 0; k < 4; ++k) one_more(small_scene, small);  // as long as the large one
    one_more(large_scene, large);
  }
  double all = 0, worst = 0;
  for (const std::string& phase : phases) all += median(large, phase);
  for (const std::string& phase : phases) {
    const double factor = growth(phase, small, counts), share = median(large, phase) / all;
    const auto guess = [&](double q) { return factor * quantile(small.seconds.at(phase), q); };
    const auto got = [&](double q) { return quantile(large.seconds.at(phase), q); };
    const double off = guess(0.5) / got(0.5) - 1;
    if (share > 0.05)
      std::cout << name << ", " << phase << ": " << number(100 * share, "%.0f")
                << " % of the run, predicted " << number(100 * off, "%+.0f") << " %\n";
    if (share > 0.05) worst = std::max(worst, std::abs(off));
    table.row({name, phase, number(factor, "%.4g"), number(guess(0.25), "%.3g"),
               number(guess(0.5), "%.3g"), number(guess(0.75), "%.3g"), number(got(0.25), "%.3g"),
               number(got(0.5), "%.3g"), number(got(0.75), "%.3g")});
  }
  table.blank_line();
  results.add("off_" + name, 100 * worst, "%", Repeats::No);
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch16_forecast");
  Table table({"scene", "phase", "growth ≈", "predicted low ≈", "predicted ≈", "predicted high ≈",
               "low ≈", "measured ≈", "high ≈"});
  predict_and_run("hertz", hertz(64), hertz(128), table, results);
  predict_and_run("cantilever", cantilever(32), cantilever(64), table, results);
  if (run.full) {
    std::cout << "--full: four times the mesh again, one minute\n";
    Table unused = table;
    predict_and_run("hertz_full", hertz(128), hertz(256), unused, results);
  }
  write_file(run.out / "fig_16_5.csv", table.csv());
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch16_forecast", "What four times the mesh will take", SIGNORINI_CHAPTER_OUT,
                     argc, argv, chapter);
}

// Round bodies whose loads change with the polygon that a mesh makes of them, solved to an accuracy: true errors, and
// seconds of processor beside those of a solve of the last mesh alone.
// Run:  make accuracy     Reads: nothing     Writes: round_bodies.md and round_bodies.csv
// Without --full one target and one element only: a test of the errors, not a measurement.
#include "support/round_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

#include "addons/estimate/accuracy.hpp"
#include "bench/measure.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"

namespace {

using namespace signorini;
using namespace signorini::bench;
using namespace signorini_test;

/// Seconds of processor, the least of several runs.
template <typename Run>
double least_seconds(Run&& run) {
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 5; ++k) {
    const double begin = processor_seconds();
    run();
    least = std::min(least, processor_seconds() - begin);
  }
  return least;
}

/// What all of them came to.
struct Judged {
  bool good = true;
  double dearest = 0;
};

void add(const RoundBody& body, double truth, const std::string& element, double target,
         Table& table, Judged& judged) {
  AccurateSolution result;
  const double seconds = least_seconds([&] {
    result = solve_to_accuracy(body.scene(element, 1), {target, body.goal});
  });
  const double alone = least_seconds([&] { (void)solved(result.scene, body.name); });
  const AccuracyRound& last = result.rounds.back();
  const double error = std::abs(last.value / truth - 1);
  judged.good = judged.good && result.met && error < target;
  judged.dearest = std::max(judged.dearest, seconds / alone);
  const auto percent = [](double part) { return number(100 * part, "%.3g"); };
  table.row({body.name, body.goal.name, element, percent(target), result.met ? "yes" : "NO",
             std::to_string(result.rounds.size()), std::to_string(last.unknowns),
             last.error ? percent(*last.error / std::abs(last.value)) : "-", percent(error),
             number(seconds, "%.4f"), number(alone, "%.4f"), number(seconds / alone, "%.2f")});
  if (!result.met)
    std::cout << body.name << ", " << body.goal.name << ": " << result.verdict << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  const auto body = [](const ProgramOptions& options) {
    const std::vector<double> targets =
        options.full ? std::vector<double>{0.01, 0.003, 0.001} : std::vector<double>{0.01};
    const std::vector<std::string> elements =
        options.full ? std::vector<std::string>{"q4_incompatible", "t3", "t6", "q8"}
                     : std::vector<std::string>{"q4_incompatible"};
    Table table({"body", "goal", "element", "target %", "met", "meshes", "unknowns", "estimate %",
                 "true error %", "s", "s of the last mesh alone", "times as long"});
    Judged judged;
    for (const RoundBody& round : all_round_bodies()) {
      const double truth = truth_of(round, options.full ? 16 : 8);
      for (const std::string& element : elements)
        for (const double target : targets) add(round, truth, element, target, table, judged);
    }
    write_table(options.out, "round_bodies", table);
    std::cout << "\ntrue errors below the targets: " << (judged.good ? "all" : "NOT ALL")
              << "; at most " << number(judged.dearest, "%.2f")
              << " times as long as the last mesh alone\n";
    return judged.good ? SolveStatus::Solved : SolveStatus::Breakdown;
  };
  return run_program("round_bodies", "Round bodies to an accuracy; --full measures",
                     SIGNORINI_BENCH_OUT, argc, argv, body);
}

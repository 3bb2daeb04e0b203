// Chapter 16 - An accuracy that is asked for: what each mesh of `signorini solve footing.toml --accuracy 0.5%` comes to.
// Run:  make ch16     Reads: examples/footing.toml     Writes: ch16_to_accuracy.results, rounds.md
// --full: 0.1 % as well, against a truth to 0.01 %, some seconds.
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include "addons/estimate/accuracy.hpp"
#include "addons/files/scene_file.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;

// 1. What the program would choose: the force is known from the load, so it is the settlement of the footing.
// [asked]
AccurateSolution asked_for(double target) {
  const Scene scene = read_scene(SIGNORINI_CHAPTER_DATA "/../../examples/footing.toml").scene;
  const Goal settlement = {"settlement", Displacement{"footing", Axis::Y, "top"}};
  return solve_to_accuracy(scene, {target, settlement});
}
// [asked]

// 2. The errors of the value of each mesh, with and without the estimate, beside the size of the estimate.
double rounds(double target, double truth, Table& table) {
  const AccurateSolution found = asked_for(target);
  const auto percent = [&](double value) { return 100 * std::abs(value / truth - 1); };
  for (std::size_t k = 0; k < found.rounds.size(); ++k) {
    const AccuracyRound& now = found.rounds[k];
    table.row({number(static_cast<double>(k + 1)), number(static_cast<double>(now.unknowns)),
               now.error ? number(100 * *now.error / std::abs(now.value), "%.3f") : "-",
               number(percent(now.of_mesh), "%.3f"), number(percent(now.value), "%.3f"),
               number(now.seconds, "%.2g")});
  }
  return percent(found.rounds.back().value);
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch16_to_accuracy");
  const double truth = asked_for(run.full ? 1e-4 : 2e-4).rounds.back().value;
  const std::vector<std::string> columns = {"mesh",     "unknowns",   "estimate [%]",
                                            "mesh [%]", "answer [%]", "seconds ≈"};
  Table table(columns);
  results.add("asked_and_off", rounds(0.005, truth, table), "%");
  std::cout << table.markdown();
  write_file(run.out / "rounds.md", table.markdown());
  if (run.full) {
    Table further(columns);
    rounds(0.001, truth, further);
    std::cout << "--full: 0.1 %\n" << further.markdown();
  }
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch16_to_accuracy", "An accuracy that is asked for", SIGNORINI_CHAPTER_OUT,
                     argc, argv, chapter);
}

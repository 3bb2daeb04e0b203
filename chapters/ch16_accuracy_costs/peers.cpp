// Chapter 16 - The same contact by other people's programs, as `make peers` measured it on one day.
// Run:  make ch16     Reads: peers.csv beside it     Writes: ch16_peers.results, peers.md, fig_16_3.csv
#include <cmath>
#include <iostream>

#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "support/measured_once.hpp"

namespace {

using namespace signorini;

// For every mesh peers.csv has its nodes, then of each program seconds, MB and the larger error of q0 and b.
struct Program {
  std::string name, key;
};
const std::vector<Program> programs = {{"signorini", "own"},
                                       {"GetFEM, nodal", "getfem"},
                                       {"CalculiX, surface to surface", "surfaces"},
                                       {"CalculiX, node to surface", "nodes"}};

SolveStatus chapter(const ProgramOptions& run) {
  const std::vector<std::vector<double>> rows = signorini_test::measured_once(SIGNORINI_CHAPTER_DATA "/peers.csv");
  Table table({"nodes", "program", "s", "MB", "larger error [%]"});
  const auto cell = [](double x, const char* format) {
    return std::isnan(x) ? std::string("-") : number(x, format);
  };
  for (const std::vector<double>& row : rows)
    for (std::size_t k = 0; k < programs.size(); ++k)
      table.row({number(row[0], "%.0f"), programs[k].name, cell(row[1 + 3 * k], "%.3g"),
                 cell(row[2 + 3 * k], "%.0f"), cell(row[3 + 3 * k], "%.4f")});
  std::cout << table.markdown();
  write_file(run.out / "peers.md", table.markdown());
  write_file(run.out / "fig_16_3.csv", signorini_test::committed(SIGNORINI_CHAPTER_DATA "/peers.csv"));

  Results results("ch16_peers");  // on the finest mesh, ours over theirs
  const std::vector<double>& finest = rows.back();
  results.add("own_error", finest[3], "%");
  for (std::size_t k = 1; k < programs.size(); ++k) {
    results.add(programs[k].key + "_seconds", finest[1] / finest[1 + 3 * k], "-");
    results.add(programs[k].key + "_memory", finest[2] / finest[2 + 3 * k], "-");
    results.add(programs[k].key + "_error", finest[3 + 3 * k], "%");
  }
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch16_peers", "The same contact by other people's programs",
                     SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}

// Chapter 21 - Past one machine: what MUMPS on several processes computes, sends and keeps, as it was measured once.
// Run:  make ch21     Reads: back_ends.csv beside it     Writes: ch21_back_ends.results, back_ends.md
#include <algorithm>
#include <cmath>
#include <iostream>

#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "support/measured_once.hpp"

namespace {

using namespace signorini;

/// A run on several processes: operations [1e9], bytes sent and memory [MB] of each.
struct Run {
  double unknowns, processes;
  std::vector<double> operations, sent, memory;
};

std::vector<Run> runs() {
  std::vector<Run> all;
  for (const std::vector<double>& row : signorini_test::measured_once(SIGNORINI_CHAPTER_DATA "/back_ends.csv")) {
    if (all.empty() || all.back().unknowns != row[0] || all.back().processes != row[1])
      all.push_back({row[0], row[1], {}, {}, {}});
    all.back().operations.push_back(row[2]);
    all.back().sent.push_back(row[3]);
    all.back().memory.push_back(row[4]);
  }
  return all;
}

double sum(const std::vector<double>& values) {
  double total = 0;
  for (const double value : values) total += value;
  return total;
}

std::string each(const std::vector<double>& values, const char* format) {
  std::string list;
  for (const double value : values)
    list += (list.empty() ? "" : ", ") + (std::isnan(value) ? "-" : number(value, format));
  return list;
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch21_back_ends");
  Table table({"unknowns", "processes", "operations of each [10⁹]", "sent by each [MB]",
               "operations for a byte", "memory of each [MB]", "largest / alone"});
  double alone = 0, alone_with = 0;
  for (const Run& now : runs()) {
    const double largest = *std::max_element(now.memory.begin(), now.memory.end());
    if (now.processes == 1) {
      alone = largest;
      alone_with = now.unknowns;
    }
    const double for_a_byte = 1e3 * sum(now.operations) / sum(now.sent);
    const bool compared = alone_with == now.unknowns;
    table.row({number(now.unknowns), number(now.processes), each(now.operations, "%.2f"),
               now.processes > 1 ? each(now.sent, "%.0f") : "",
               std::isfinite(for_a_byte) ? number(for_a_byte, "%.0f") : "",
               each(now.memory, "%.0f"), compared ? number(largest / alone, "%.2f") : ""});
    const std::string with = number(now.unknowns / 1000) + "_" + number(now.processes);
    if (std::isfinite(for_a_byte)) results.add("for_a_byte_" + with, for_a_byte, "-");
    if (compared && now.processes > 1) results.add("memory_" + with, largest / alone, "-");
  }
  std::cout << table.markdown();
  write_file(run.out / "back_ends.md", table.markdown());
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch21_back_ends", "Past one machine", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}

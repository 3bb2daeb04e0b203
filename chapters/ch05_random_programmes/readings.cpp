// Chapter 5 - What a printed ratio says about a program that nobody has: readings of the method at the sizes of table 1.
// Run:  make ch05     Reads: nothing     Writes: ch05_readings.results, readings.md, readings_by_size.md,
//                                                fig_5_4.csv, fig_5_4_whole.csv
// --full: a hundred programmes of each size in the place of ten.
#include "readings.hpp"

#include <iostream>

#include "../../tests/reference/rosen_suzuki_table_1.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch05;

/// Of a problem with one pair, for their names.
const std::vector<MethodReading>& readings() {
  static const std::vector<MethodReading> named =
      method_readings({Eigen::MatrixXd::Identity(1, 1), VectorXd::Constant(1, -1)});
  return named;
}

// 1. Every reading on every programme of one size: the ratio of table 1 less one.
std::vector<std::vector<double>> run_all(Draw draw, const reference::RandomProgramme& line,
                                         std::uint64_t seeds) {
  std::vector<std::vector<double>> found(readings().size());
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const std::vector<double> one = deviations(draw(line.n, line.m, seed));
    for (std::size_t i = 0; i < found.size(); ++i) found[i].push_back(one[i]);
  }
  return found;
}

// 2. All sizes: counts of each reading, a row for each size, and what figure 5.4 shows.
struct Outcome {
  std::vector<Counts> counts = std::vector<Counts>(readings().size());
  std::vector<double> right_lines = std::vector<double>(readings().size());  // more than half as printed
};

Outcome all_sizes(const char* name, Draw draw, std::uint64_t seeds, Table& by_size, Table& curve) {
  Outcome outcome;
  double place = 0;
  for (const reference::RandomProgramme& line : reference::table_1) {
    const auto found = run_all(draw, line, seeds);
    std::vector<double> row = {place++, line.ratio - 1};
    for (std::size_t i = 0; i < readings().size(); ++i) {
      Counts here;
      for (const double own : found[i]) {
        here.add(line.ratio - 1, own);
        outcome.counts[i].add(line.ratio - 1, own);
      }
      outcome.right_lines[i] += here.percent(here.both) > 50 ? 1 : 0;
      for (const double share : {0.1, 0.5, 0.9}) row.push_back(at_share(found[i], share));
      by_size.row({name, text(line.n, ", ", line.m), number(line.ratio - 1, "%+.1e"), readings()[i].key,
                   number(here.above, "%.0f"), number(here.none, "%.0f"),
                   number(here.below, "%.0f"), number(at_share(found[i], 0.5), "%+.0e")});
    }
    curve.row(row);
  }
  return outcome;
}

std::vector<std::string> columns() {
  std::vector<std::string> names = {"place", "paper"};
  for (const MethodReading& reading : readings())
    for (const char* share : {"_10", "_50", "_90"}) names.push_back(reading.key + share);
  return names;
}

// 3. Two ways to draw programmes, one table of shares.
SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch05_readings");
  const std::uint64_t seeds = run.full ? 100 : 10;
  Table by_size({"programmes", "$`n`$, $`m`$", "paper", "reading", "> 1", "1", "< 1", "median"});
  Table curve(columns()), other(columns());
  const Outcome ours = all_sizes("as in chapter 5", rosen_suzuki, seeds, by_size, curve);
  const Outcome whole = all_sizes("whole numbers", whole_number_programme, seeds, by_size, other);
  write_file(run.out / "readings_by_size.md", by_size.markdown());
  write_file(run.out / "fig_5_4.csv", curve.csv("rel 1e-3 abs 1e-9"));
  write_file(run.out / "fig_5_4_whole.csv", other.csv("rel 1e-3 abs 1e-9"));

  Table shares({"reading", "sign", "size", "both", "whole numbers: sign", "size", "both"});
  for (std::size_t i = 0; i < readings().size(); ++i) {
    std::vector<std::string> row = {readings()[i].name};
    for (const Counts& counts : {ours.counts[i], whole.counts[i]})
      for (const double count : {counts.sign, counts.size, counts.both})
        row.push_back(number(counts.percent(count), "%.0f"));
    shares.row(row);
    const std::string& key = readings()[i].key;
    results.add(key + "_above", ours.counts[i].percent(ours.counts[i].above), "%");
    results.add(key + "_below", ours.counts[i].percent(ours.counts[i].below), "%");
    results.add(key + "_both", ours.counts[i].percent(ours.counts[i].both), "%");
    results.add(key + "_both_whole", whole.counts[i].percent(whole.counts[i].both), "%");
    results.add(key + "_lines", ours.right_lines[i], "-");
  }
  write_file(run.out / "readings.md", shares.markdown());
  std::cout << shares.markdown();
  results.add("programmes", static_cast<double>(std::size(reference::table_1) * seeds), "-");
  results.add("chance_of_signs", 100.0 * 2 * (12 + 1) / 4096, "%");  // 11 or 12 of 12 coins alike
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch05_readings", "Readings of a ratio", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}

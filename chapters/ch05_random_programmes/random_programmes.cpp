// Chapter 5 - Random programmes (Xuan & Li 2002, sec. 4, example 1, table 1).
// Run:  make ch05     Reads: nothing     Writes: ch05.results, table.md, all_sizes.md, fig_5_1.csv
#include <iostream>

#include "../../tests/reference/rosen_suzuki_table_1.hpp"
#include "judge.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch05;

// 1. One size with five seeds: how many steps each of three methods takes.
struct Runs {
  std::vector<Run> lemke, single, group;
  int right = 0, below_zero = 0;
  double worst = 0;  // deviation of our energies
};

Runs five_seeds(Eigen::Index n, Eigen::Index m) {
  Runs runs;
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    const KnownProgramme known = rosen_suzuki(n, m, seed);
    runs.lemke.push_back(timed(known, "lemke"));
    runs.single.push_back(judged(known, "goldfarb_idnani"));
    runs.group.push_back(timed(known, ours));
    runs.worst = std::max(runs.worst, runs.group.back().deviation);
    runs.below_zero += known.energy < 0 ? 1 : 0;
    for (const auto& list : {runs.lemke, runs.single, runs.group})
      runs.right += list.back().right ? 1 : 0;
  }
  return runs;
}

// 2. Table 1: every size, medians.
SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch05");
  Table sizes({"$`n`$", "$`m`$", "closed", "Lemke: pivots", "Goldfarb-Idnani: steps", "ours: steps",
               "ours: factorisations", "paper: $`f_P/f_L - 1`$",
               "ours: $`\\lvert f/f^* - 1\\rvert`$", "certificate ≤ 1e-12"});
  Table some = sizes;
  Table deviations({"place", "n", "m", "paper", "ours"});
  Table times({"n", "m", "Lemke / ours", "in the paper"});
  int below_zero = 0, right = 0;
  for (const reference::RandomProgramme& line : reference::table_1) {
    const Runs runs = five_seeds(line.n, line.m);
    const std::string n = std::to_string(line.n), m = std::to_string(line.m);
    const std::vector<std::string> row = {
        n,
        m,
        number(median(runs.group, &Run::closed)),
        number(median(runs.lemke, &Run::steps)),
        number(median(runs.single, &Run::steps)),
        number(median(runs.group, &Run::steps)),
        number(median(runs.group, &Run::factorisations)),
        number(line.ratio - 1, "%+.1e"),
        runs.worst < 1e-13 ? "< 1e-13" : number(runs.worst, "%.0e"),
        runs.right == 15 ? "yes" : "no"};
    sizes.row(row);
    if (line.m == line.n || line.m == 4 * line.n) some.row(row);
    deviations.row({number(static_cast<double>(&line - reference::table_1.data())), n, m,
                    number(std::abs(line.ratio - 1)), number(std::max(runs.worst, 1e-16))});
    const double ratio = median(runs.lemke, &Run::seconds) / median(runs.group, &Run::seconds);
    times.row(
        {n, m, number(ratio, "%.2f"), number(line.lemke_seconds / line.paper_seconds, "%.2f")});
    results.add(text("lemke_over_ours_", n, '_', m), ratio, "-", Repeats::No);
    below_zero += runs.below_zero;
    right += runs.right;
  }
  write_file(run.out / "all_sizes.md", sizes.markdown());
  write_file(run.out / "table.md", some.markdown());
  write_file(run.out / "fig_5_1.csv", deviations.csv("rel 1e-6 abs 1e-11"));
  std::cout << times.markdown();
  results.add("energies_below_zero", below_zero, "-");
  results.add("right_runs", right, "-");
  results.headline("right_runs", 180, "12 sizes, 5 seeds, 3 methods");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch05", "Random programmes", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}

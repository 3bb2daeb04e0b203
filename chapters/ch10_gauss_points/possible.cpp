// Chapter 10 - How many pressures the nodes can tell apart, and what each may be (Lin et al., sec. 2.4, eq. 37).
// Run:  make ch10     Reads: nothing     Writes: ch10_possible.results, rank.md,
//       possible.md, fig_10_2*.csv
#include <algorithm>
#include <cmath>
#include <iostream>

#include "interfaces.hpp"
#include "possible_pressures.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch10;
using Eigen::Index;

const char* tolerance = "rel 1e-4 abs 1e-6";  // of the curves
const double q0 = hertz_peak_pressure(hertz_contact);
const double b = hertz_half_width(hertz_contact);

// 1. Two blocks: how many pressures the nodes can tell apart, and what each of them may be.
void two_blocks(const ProgramOptions& run, Results& results) {
  const std::vector<std::pair<Index, Index>> meshes = {{8, 8}, {8, 11}, {11, 8}, {7, 15}};
  Table ranks({"points", "8/8", "8/11", "11/8", "7/15"});
  Table bounds({"points", "8/8", "in closed form", "8/11", "11/8", "7/15", "disc, nodes on nodes"});
  for (int points = 1; points <= 6; ++points) {
    std::vector<std::string> rank = {std::to_string(points)}, highest = rank;
    for (const auto& [source, target] : meshes) {
      const ClosedPoints closed =
          closed_points(solved(blocks(source, target, {"gauss_points", points}), "blocks"));
      rank.push_back(text(closed.rank, " of ", closed.points.size()));
      const double most = possible_pressures(closed).highest.maxCoeff();
      highest.push_back(number(most, "%.3f"));
      const std::string key = text(points, "_", source, "_", target);
      results.add("rank_" + key, static_cast<double>(closed.rank), "-");
      results.add("highest_" + key, most, "-");
      if (&source != &meshes.front().first) continue;
      double alone = 0;  // one point carries a node: f = h = (h/2) weight N p
      for (const GaussPoint& gauss : gauss_line(points))
        alone = std::max(alone, 4 / (gauss.weight * (1 + std::abs(gauss.xi))));
      highest.push_back(points == 1 ? "" : number(alone, "%.3f"));
    }
    const SolvedScene disc = solved(hertz(16, {"gauss_points", points}), "disc");
    const ClosedPoints closed = closed_points(disc);
    const Bounds possible = possible_pressures(closed);
    const NodeArray at = disc.model.pairs.position(closed.points, Eigen::all);
    highest.push_back(number(possible.highest.maxCoeff() / q0, "%.3f"));
    ranks.row(rank);
    bounds.row(highest);
    if (points == 2 || points == 3)
      write_file(run.out / text("fig_10_2", points == 2 ? "" : "_three", ".csv"),
                 table_of({{"x", at.col(0) / b},
                           {"lowest", possible.lowest / q0},
                           {"highest", possible.highest / q0}})
                     .csv(tolerance));
  }
  std::cout << ranks.markdown() << bounds.markdown();
  write_file(run.out / "rank.md", ranks.markdown());
  write_file(run.out / "possible.md", bounds.markdown());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch10_possible");
  two_blocks(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch10_possible", "More pressures than nodes can feel", SIGNORINI_CHAPTER_OUT,
                     argc, argv, chapter);
}

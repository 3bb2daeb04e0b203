// Chapter 22 - Bodies that move: the loop on a block that is pressed and dragged, at four depths, and over many sides.
// Run:  make ch22     Reads: nothing     Writes: ch22.results, loop.md, fig_22_2.csv
#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "scenes.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch22;

// By which factor an iteration shrinks a move, on average from the third on, as long as moves are large beside rounding; in
// the digits that this leaves.
double rate(const std::vector<double>& moves) {
  std::size_t last = moves.size() - 1;
  while (moves[last] < 10 * rounding) --last;
  return std::stod(number(std::pow(moves[last] / moves[2], 1 / double(last - 2)), "%.2g"));
}

// Pressed by a depth, then dragged by 0.1 mm: the second step, whose moves are a curve of the figure.
Place dragged(const Assembled& bodies, double depth, int corrections, Table& curve) {
  const Place pressed = step(bodies, at_rest(bodies), {0, -depth});
  Place end = step(bodies, pressed.u, {0.1, -depth}, 60, corrections);
  for (std::size_t k = 0; k < end.moves.size(); ++k)
    curve.row({depth, double(corrections), double(k + 1), std::max(end.moves[k], rounding)});
  curve.blank_line();
  return end;
}

void depths(const ProgramOptions& run, Results& results) {
  const Assembled bodies = assembled(blocks(1));
  Table curve({"depth", "corrections", "iteration", "move"});
  Table table({"depth over height", "iterations", "rate", "rate over depth"});
  for (const double depth : {0.05, 0.02, 0.005, 0.001}) {
    const Place frozen = dragged(bodies, depth, 0, curve);
    if (depth == 0.05) results.add("iterations_of_0", double(frozen.moves.size()), "-");
    const double shrinks = rate(frozen.moves);
    table.row({number(depth), number(double(frozen.moves.size())), number(shrinks, "%.2g"),
               number(shrinks / depth, "%.1f")});
    results.add(text("rate_", number(1000 * depth)), shrinks, "-");
  }
  for (const int corrections : {1, 6}) {
    const Place corrected = dragged(bodies, 0.05, corrections, curve);
    results.add(text("iterations_of_", corrections), double(corrected.moves.size()), "-");
  }
  std::cout << table.markdown();
  write_file(run.out / "loop.md", table.markdown());
  write_file(run.out / "fig_22_2.csv", curve.csv("rel 1e-2 abs 2e-12"));
}

// Over some 12 sides of a base that hardly gives: friction is mu times pressure, wherever the nodes are.
void drag(Results& results) {
  const Assembled bodies = assembled(blocks(1000));
  NodeArray u = at_rest(bodies);
  double least = 1, most = 0, iterations = 0;
  const int steps = 30;
  for (int k = 0; k <= steps; ++k) {
    const Place now = step(bodies, u, {3.0 * k / steps, -0.02});
    u = now.u;
    const Vector2d force = force_on_tool(now);
    iterations += double(now.moves.size());
    if (k == 0) continue;
    least = std::min(least, -force.x() / force.y());
    most = std::max(most, -force.x() / force.y());
    if (k == steps) results.add("ratio", -force.x() / force.y(), "-");
  }
  results.add("ratio_least", least, "-");
  results.add("ratio_most", most, "-");
  results.add("iterations", iterations / (steps + 1), "-");
  results.headline("ratio", mu, "Coulomb's law");
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch22");
  depths(run, results);
  drag(results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch22", "Bodies that move", SIGNORINI_CHAPTER_OUT, argc, argv,
                                chapter);
}

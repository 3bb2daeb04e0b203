// Chapter 22 - A die irons a slab: with gaps of nodes, whose normals jump at corners, and with weighted gaps.
// Run:  make ch22     Reads: nothing     Writes: ch22_corners.results, corners.md, fig_22_4.csv, fig_22_4_moves.csv
#include <functional>
#include <iostream>

#include "scenes.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch22;

const std::size_t most = 40;  // iterations of a step

/// What became of the steps.
struct Ironing {
  int stuck = 0;               // did not arrive
  double iterations = 0;       // of a step, on average
  std::vector<double> moves;   // of the first step that did not arrive, else of the last
};

using Watch = std::function<void(int, const Place&)>;

// Down in one step, then along by 1 mm.
Ironing iron(const Two& scene, double depth, int steps, const Watch& watch = {}) {
  const Assembled bodies = assembled(scene);
  NodeArray u = at_rest(bodies);
  Ironing all;
  for (int k = 0; k <= steps; ++k) {
    const Place now = step(bodies, u, {double(k) / steps, -depth}, most);
    u = now.u;
    all.iterations += double(now.moves.size()) / (steps + 1);
    if (all.stuck == 0) all.moves = now.moves;
    if (!now.arrived) ++all.stuck;
    if (watch) watch(k, now);
  }
  return all;
}

Table count(Results& results) {
  Table table({"gaps", "cells along the slab", "depth [mm]", "steps that do not arrive, of 21",
               "iterations of a step"});
  for (const auto& [fine, depth] : {std::pair<Index, double>{1, 0.05}, {1, 0.1}, {2, 0.1}})
    for (const char* name : {"node_to_segment", "mortar"}) {
      const Ironing all = iron(ironing(name, fine), depth, 20);
      table.row({name == std::string("mortar") ? "weighted" : "of nodes", number(32.0 * double(fine)),
                 number(depth), number(all.stuck), number(all.iterations, "%.0f")});
      results.add(text("stuck_", name, "_", fine, "_", number(100 * depth)), all.stuck, "-");
    }
  return table;
}

// Forces along the path of 80 steps, of both.
void forces(const ProgramOptions& run, Results& results) {
  Table path({"gaps", "way", "press", "drag"}), moves({"gaps", "iteration", "move"});
  for (const char* name : {"node_to_segment", "mortar"}) {
    const bool weighted = name == std::string("mortar");
    double least = 1e300, largest = 0;
    const Ironing all =
        iron(ironing(name, 1), 0.1, 80, [&](int k, const Place& now) {
          const Vector2d force = force_on_tool(now);
          path.row({weighted ? 1.0 : 0.0, k / 80.0, force.y(), -force.x()});
          if (k >= 20) least = std::min(least, -force.x()), largest = std::max(largest, -force.x());
        });
    for (std::size_t k = 0; k < all.moves.size(); ++k)
      moves.row({weighted ? 1.0 : 0.0, double(k + 1), std::max(all.moves[k], rounding)});
    path.blank_line();
    moves.blank_line();
    results.add(text("stuck_", name), all.stuck, "-");
    results.add(text("wave_", name), largest - least, "N");  // of the drag, once all slides
  }
  write_file(run.out / "fig_22_4.csv", path.csv("rel 1e-4 abs 1e-6"));
  write_file(run.out / "fig_22_4_moves.csv", moves.csv("rel 1e-2 abs 2e-12"));
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch22_corners");
  const Table table = count(results);
  std::cout << table.markdown();
  write_file(run.out / "corners.md", table.markdown());
  forces(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch22_corners", "Corners", SIGNORINI_CHAPTER_OUT, argc, argv,
                                chapter);
}

// Chapter 9 - The patch test: one pressure through meshes that do not match (Lin et al., sec. 2.3).
// Run:  make ch09     Reads: nothing     Writes: ch09_patch_test.results, patch.md,
//       fig_9_3.csv
#include <cmath>
#include <iostream>

#include "blocks.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/fem/assembly.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/report/shown.hpp"

namespace {

using namespace ch09;
using namespace signorini;

std::string percent(double x) { return x < 1e-12 ? "below 1e-10" : number(100 * x, "%.2f"); }

// 1. The scene, and what became of the pressure.
/// Two blocks under one pressure on all sides.
/// \param upper         cells of the upper block along the interface
/// \param lower         cells of the lower one
/// \param source        which side it is
/// \param gap_operator  of the contact
Scene patch(Index upper, Index lower, Source source, const std::string& gap_operator) {
  Scene scene = blocks(block("lower", {0, 0}, {2, 1}, lower, 3),
                       block("upper", {0, 1}, {2, 1}, upper, 3), source, gap_operator);
  for (Body& body : scene.bodies) {
    body.element = "q4";
    body.material.poisson_ratio = 0.3;
    body.loads.edges = {{"left", 0.01, {}}, {"right", 0.01, {}}};
  }
  scene.bodies[0].supports = {prescribed("bottom", Axis::Y, 0),
                              prescribed_at("bottom", {0, 0}, Axis::X)};
  scene.bodies[1].supports = {prescribed_at("top", {0, 2}, Axis::X)};  // contact must hold the rest
  scene.bodies[1].loads.edges.push_back({"top", 0.01, {}});
  return scene;
}

/// What became of a uniform pressure.
struct Pressed {
  double deviation;  ///< largest |pressure / uniform - 1|
  double overlap;    ///< over the compression of both blocks
};

/// Solves a patch test; arguments as for patch().
Pressed pressed(Index upper, Index lower, Source source, const char* gap_operator) {
  const Scene scene = patch(upper, lower, source, gap_operator);
  const SolvedScene run = shown(scene, "the patch test");
  const double compression = 2 * 1.3 * 0.4 * 0.01;  // height (1 + nu)(1 - 2 nu) p / E
  return {(run.solution.pressure.array() / 0.01 - 1).abs().maxCoeff(),
          overlap(scene, run) / compression};
}

// 2. The patch test, both ways round, and finer.
void patch_test(const ProgramOptions& run, Results& results) {
  Table table({"edges above", "below", "source above: pressure", "overlap",
               "source below: pressure", "overlap ", "mortar: pressure"});
  Table curve({"x", "p"});
  for (const auto& [above, below] : {std::pair(8, 11), std::pair(11, 8), std::pair(7, 15),
                                     std::pair(7, 10), std::pair(16, 22), std::pair(32, 44)}) {
    const Pressed up = pressed(above, below, Source::Upper, "node_to_segment");
    const Pressed low = pressed(above, below, Source::Lower, "node_to_segment");
    table.row({std::to_string(above), std::to_string(below), percent(up.deviation),
               percent(up.overlap), percent(low.deviation), percent(low.overlap),
               percent(pressed(above, below, Source::Upper, "mortar").deviation)});
    const std::string name = text("_", above, "_", below);
    results.add("deviation" + name, 100 * up.deviation, "%");
    results.add("overlap" + name, 100 * up.overlap, "%");
    if (name != "_8_11" && name != "_7_15") continue;
    const Scene scene = patch(above, below, Source::Upper, "node_to_segment");
    const SolvedScene one = solved(scene, "patch test");
    for (Index i = 0; i < one.solution.pressure.size(); ++i)
      curve.row({one.model.pairs.position(i, 0), one.solution.pressure(i) / 0.01});
    curve.blank_line();
    const BoundaryForces under = boundary_forces(one, {"top", "lower"});
    for (Index i = 0; i < under.weight.size(); ++i)
      curve.row({under.position(i, 0), -under.force(i, 1) / under.weight(i) / 0.01});
    curve.blank_line();
  }
  std::cout << table.markdown();
  write_file(run.out / "patch.md", table.markdown());
  write_file(run.out / "fig_9_3.csv", curve.csv());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch09_patch_test");
  patch_test(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch09_patch_test", "Balanced is not uniform", SIGNORINI_CHAPTER_OUT, argc,
                     argv, chapter);
}

// Chapter 21 - Where condensing loses: a spring of more and more leaves.
// Run:  make ch21     Reads: nothing     Writes: ch21_leaves.results, fig_21_4.csv
#include <cmath>
#include <iostream>

#include "papers/saddle_point_newton.hpp"
#include "scenes.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/pairing/mortar.hpp"  // the operators of these contacts, linked with it
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/scene/readings.hpp"
#include "support/processor_time.hpp"

namespace {

using namespace ch21;
using signorini_test::processor_seconds;

// 1. One block of cells, cut into leaves that are clamped on the left and pressed on the top of the upper one.
const double pressure = 1e-3;  // on the top [kN/cm^2]

Scene leaf_spring(Index leaves, Index cells_x, Index cells_y) {
  Scene scene;
  scene.bodies.clear();
  for (Index k = 0; k < leaves; ++k) {
    BlockSpec spec;
    spec.name = text("leaf ", k);
    spec.size = {100, 20.0 / static_cast<double>(leaves)};
    spec.corner = {0, 20.0 - spec.size.y() * static_cast<double>(k + 1)};
    spec.cells_x = cells_x;
    spec.cells_y = cells_y / leaves;
    Body& leaf = scene.bodies.emplace_back();
    leaf.mesh = make_block(spec);
    leaf.material = {2.1e4, 0.3, PlaneState::Stress, 1};
    leaf.supports = {fixed("left")};
    if (k > 0) scene.contacts.push_back({{"bottom", text("leaf ", k - 1)}, Side{"top", spec.name}});
  }
  scene.bodies[0].loads.edges = {{"top", pressure, {}}};
  return scene;
}

// 2. What each number of leaves takes: counted up to the first step of contact, and in seconds to the end.
struct Price {
  double pairs = 0, factor = 0, rows = 0;  // operations of K = L L^T and of A K^-1 A^T
  double condensed = 0, uncondensed = 0;   // seconds
  [[nodiscard]] double dense() const {
    return pairs * pairs * pairs / 3;
  }  // one factor of all pairs
};

Price price(Index leaves) {
  const Scene scene = leaf_spring(leaves, 120, 24);
  Price paid;
  const double begin = processor_seconds();
  const SolvedScene run = solved(scene, "the spring");
  paid.condensed = processor_seconds() - begin;
  const Ledger& ledger = run.solution.ledger;
  paid.pairs = static_cast<double>(run.model.pairs.weight.size());
  paid.factor = static_cast<double>(ledger.counted("factor/numeric", "operations"));
  paid.rows = static_cast<double>(ledger.counted("condensation", "operations"));
  if (leaves > 1) {
    SaddlePointOptions options;
    options.start_force = pressure * run.model.pairs.weight;  // as if every leaf handed it on
    const double start = processor_seconds();
    const SaddlePointSolution found = saddle_point_newton(run.model.programme, options);
    paid.uncondensed = processor_seconds() - start;
    if (found.report.status != SolveStatus::Solved)
      throw NotSolved("Newton's method found no solution");
  }
  return paid;
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch21_leaves");
  Table curve({"leaves", "pairs", "factor", "rows", "dense", "condensed ≈", "not condensed ≈"});
  const double plain = price(1).factor;
  for (const Index leaves : {2, 3, 4, 6, 8, 12}) {
    const Price paid = price(leaves);
    curve.row({text(leaves), number(paid.pairs), number(paid.factor / plain),
               number(paid.rows / plain), number(paid.dense() / plain),
               number(paid.condensed, "%.2g"), number(paid.uncondensed, "%.2g")});
  }
  results.add("break_even", std::cbrt(3 * plain), "-");
  if (run.full) std::cout << "--full: 24 leaves: " << price(24).condensed << " s condensed\n";
  std::cout << curve.markdown();
  write_file(run.out / "fig_21_4.csv", curve.csv());
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch21_leaves", "Where condensing loses", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}

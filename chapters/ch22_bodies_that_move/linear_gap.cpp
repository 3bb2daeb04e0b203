// Chapter 22 - What a gap and a slip that are linear forget: the way along a round side, and a turn.
// Run:  make ch22     Reads: nothing     Writes: ch22_linear_gap.results, turned.md, fig_22_1.csv
#include <iostream>

#include "scenes.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch22;

// A point on a disc slides by s along its tangent. The linear gap stays what it was.
void along_a_disc(const ProgramOptions& run, Results& results) {
  const double radius = 10;
  const Obstacle round = disc({0, -radius}, radius);
  Table curve({"way", "error", "expected"});
  for (int k = -8; k <= 2; ++k) {
    const double way = std::pow(10, k / 4.0);
    const double linear = round.look({0, 0}).gap + round.look({0, 0}).normal.dot(Vector2d(way, 0));
    curve.row({way, round.look({way, 0}).gap - linear, way * way / (2 * radius)});
  }
  results.add("off_at_one", round.look({1, 0}).gap, "mm");
  write_file(run.out / "fig_22_1.csv", curve.csv());
}

NodeArray turned(const NodeArray& x, double angle) {
  Eigen::Matrix2d turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return x * turn.transpose();
}

// A block slides by 0.5 mm on its base. Then both turn as one, and nothing slides.
void after_a_turn(const ProgramOptions& run, Results& results) {
  const Assembled bodies = assembled(blocks(1));
  const NodeArray zero = at_rest(bodies);
  NodeArray slid = zero;
  slid.bottomRows(bodies.model.bodies[1].mesh.n_nodes()).col(0).setConstant(0.5);
  const NodeArray stood = places(bodies.model, zero), slid_to = places(bodies.model, slid);
  const Pairs first = pairs_at(bodies, zero, zero);
  Table table({"turn", "linear gap [mm]", "gap [mm]", "linear slip [mm]", "slip [mm]"});
  for (const double angle : {0.0, 0.01, 0.1, 0.5, std::acos(0.0)}) {
    const NodeArray u = turned(slid_to, angle) - stood;
    const Eigen::Map<const VectorXd> flat(u.data(), u.size());
    const Pairs there = pairs_at(bodies, u, zero);
    const Index middle = first.weight.size() / 2;
    table.row({number(angle, "%.3f"), number((first.opening * flat)(middle), "%.4f"),
               number(std::abs(there.initial_gap(middle)), "%.4f"),
               number((first.sliding * flat)(middle), "%.4f"),
               number(there.slid(middle), "%.4f")});
    if (angle == 0.1) results.add("gap_after_a_turn", (first.opening * flat)(middle), "mm");
  }
  std::cout << table.markdown();
  write_file(run.out / "turned.md", table.markdown());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch22_linear_gap");
  along_a_disc(run, results);
  after_a_turn(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch22_linear_gap", "What a linear gap forgets",
                                SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}

// Chapter 22 - What small strain makes of a turn.
// Run:  make ch22     Reads: nothing     Writes: ch22_turning.results, turning.md
#include <iostream>

#include "scenes.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch22;

// Everything turns as one, contact forces too: what is then out of balance, over the largest contact force.
double left_over(const Assembled& bodies, const Place& pressed, double angle) {
  Eigen::Matrix2d turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  const NodeArray stood = places(bodies.model, at_rest(bodies));
  const NodeArray there = (stood + pressed.u) * turn.transpose();
  const NodeArray pushed = pushes(bodies, pressed) * turn.transpose();
  const VectorXd left = out_of_balance(bodies.model, there - stood) +
                        restricted(bodies.model.unknowns, pushed);
  return left.cwiseAbs().maxCoeff() / pressed.contact.force.maxCoeff();
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch22_turning");
  const Assembled bodies = assembled(blocks(1));
  const Place pressed = step(bodies, at_rest(bodies), {0, -0.02});
  const Place dragged = step(bodies, pressed.u, {0.1, -0.02});
  Table table({"turn", "strain of the turn", "out of balance"});
  for (const double angle : {0.0, 1e-3, 1e-2, 0.1, std::acos(0.0)}) {
    const double left = left_over(bodies, dragged, angle);
    table.row({number(angle, "%.3f"), number(1 - std::cos(angle), "%.6f"), number(left, "%.4f")});
    if (angle == 1e-2) results.add("left_hundredth", 100 * left, "%");
    if (angle > 1) results.add("left_quarter", left, "-");
  }
  std::cout << table.markdown();
  write_file(run.out / "turning.md", table.markdown());
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch22_turning", "What small strain makes of a turn",
                                SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}

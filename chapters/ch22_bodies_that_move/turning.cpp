// Chapter 22 - What small strain makes of a turn, and what Green's strain does.
// Run:  make ch22     Reads: nothing     Writes: ch22_turning.results, turning.md
#include <iostream>

#include "addons/motion/register.hpp"
#include "scenes.hpp"
#include "signorini/core/table.hpp"
#include "signorini/fem/strain_laws.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch22;

// A block that was pressed and dragged; the loop takes the K of small strain for either law, and a little longer.
struct Dragged {
  Assembled bodies;
  Place place;
};

Dragged dragged(const char* law) {
  Two scene = blocks(1);
  scene.base.element = scene.tool.element = "q4";
  Dragged all{assembled(scene), {}};
  for (BodyModel& body : all.bodies.model.bodies) body.material.base.law = find_strain_law(law);
  const Place pressed = step(all.bodies, at_rest(all.bodies), {0, -0.02});
  all.place = step(all.bodies, pressed.u, {0.1, -0.02});
  if (!all.place.arrived) throw NotSolved("the dragged block");
  return all;
}

// Everything turns as one, contact forces too: what is then out of balance, over the largest contact force.
double left_over(const Dragged& block, double angle) {
  Eigen::Matrix2d turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  const Model& model = block.bodies.model;
  const NodeArray stood = places(model, at_rest(block.bodies));
  const NodeArray there = (stood + block.place.u) * turn.transpose();
  const NodeArray pushed = pushes(block.bodies, block.place) * turn.transpose();
  const VectorXd left =
      out_of_balance(model, there - stood) + restricted(model.unknowns, pushed);
  return left.cwiseAbs().maxCoeff() / block.place.contact.force.maxCoeff();
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch22_turning");
  const Dragged small = dragged("small"), green = dragged("st_venant_kirchhoff");
  Table table({"turn", "size of the strain of the turn", "left over, small strain", "left over, Green's strain"});
  double most = 0;
  for (const double angle : {0.0, 1e-3, 1e-2, 0.1, std::acos(0.0)}) {
    const double left = left_over(small, angle), none = left_over(green, angle);
    table.row({number(angle, "%.3f"), number(1 - std::cos(angle), "%.6f"), number(left, "%.4f"),
               number(none, "%.4f")});
    most = std::max(most, none);
    if (angle == 1e-2) results.add("left_hundredth", 100 * left, "%");
    if (angle > 1) results.add("left_quarter", left, "-");
  }
  results.add("left_green", most, "-", Repeats::No);
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

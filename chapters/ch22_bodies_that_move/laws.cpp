// Chapter 22 - A block between smooth plates, pressed ever flatter, by three laws.
// Run:  make ch22     Reads: nothing     Writes: ch22_laws.results, fig_22_5.csv, fig_22_5_exact.csv
#include <algorithm>
#include <cmath>

#include "addons/motion/register.hpp"
#include "addons/steps/steps.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "meshes/block.hpp"
#include "signorini/fem/strain_laws.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;

const double nu = 0.3;  // and a modulus of 1, so that forces are parts of it

// A unit block on rollers, pressed down to a height in steps.
Scene pressed(const char* law, double height, int steps) {
  Scene scene;
  Body& body = scene.bodies[0];
  body.element = "q4";
  body.mesh = block("block", {0, 0}, {1, 1}, 2, 2);
  body.material = {1, nu, PlaneState::Strain, 1};
  body.material.law = find_strain_law(law);
  body.supports = {symmetric("bottom"), symmetric("left"),
                   prescribed("top", Axis::Y, height - 1)};
  body.supports[2].history = "press";
  scene.path = Path{equal_steps(steps), {proportional("press")}};
  return scene;
}

// Force over the modulus and the width before strain, at a height s of one.
double small(double s) { return (1 - s) / (1 - nu * nu); }

double st_venant_kirchhoff(double s) { return s * (1 - s * s) / (2 * (1 - nu * nu)); }

double neo_hooke(double s) {
  const double mu = 1 / (2 * (1 + nu));
  const double lambda = nu / ((1 + nu) * (1 - 2 * nu));
  double w = 1;  // the width: mu (w^2 - 1) + lambda ln(w s) = 0, since nothing presses on the sides
  for (int k = 0; k < 50; ++k)
    w -= (mu * (w * w - 1) + lambda * std::log(w * s)) / (2 * mu * w + lambda / w);
  return -(mu * (s * s - 1) + lambda * std::log(w * s)) / s;
}

// The forces of a path, and how far they are from the closed form at most.
double press(const char* law, double height, int steps, double (*exact)(double), Table& points) {
  double worst = 0;
  const PathEnd end =
      solve_steps(pressed(law, height, steps), [&](const Model& model, const Step& step) {
        const double s = 1 - (1 - height) * step.state.time;
        double force = 0;
        const NodeArray all = support_forces(model, step.solution);
        for (const Eigen::Index node : boundary_nodes(model.bodies[0].mesh, "top"))
          force -= all(node, 1);
        points.row({law, number(s), number(force)});
        worst = std::max(worst, std::abs(force - exact(s)));
      });
  if (end.status != SolveStatus::Solved) throw NotSolved(end.reason);
  points.blank_line();
  return worst;
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch22_laws");
  Table points({"law", "height", "force"});
  // The block of St Venant and Kirchhoff has its largest force at 1/sqrt(3) of its height.
  results.add("off_st_venant", press("st_venant_kirchhoff", 0.6, 16, st_venant_kirchhoff, points),
              "-", Repeats::No);
  results.add("off_neo_hooke", press("neo_hooke", 0.4, 24, neo_hooke, points), "-", Repeats::No);
  Table curves({"height", "small", "st_venant", "neo_hooke"});
  for (int k = 0; k <= 60; ++k) {
    const double s = 1 - k / 100.0;
    curves.row({s, small(s), st_venant_kirchhoff(s), neo_hooke(s)});
  }
  write_file(run.out / "fig_22_5.csv", points.csv());
  write_file(run.out / "fig_22_5_exact.csv", curves.csv());
  results.add("gives_way", 1 / std::sqrt(3.0), "-");
  results.add("small_at_90", small(0.9), "-");
  results.add("st_venant_at_90", st_venant_kirchhoff(0.9), "-");
  results.add("neo_hooke_at_90", neo_hooke(0.9), "-");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch22_laws", "Three laws", SIGNORINI_CHAPTER_OUT, argc, argv,
                                chapter);
}

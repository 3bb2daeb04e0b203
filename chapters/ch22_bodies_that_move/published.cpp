// Chapter 22 - A published ironing: the forces of one die, which six sources have in six ways.
// Takes longer than 5 s: ./run.sh shows its committed results.
// Run:  make ch22     Reads: nothing     Writes: ch22_published.results
#include <cmath>
#include <utility>
#include <vector>

#include "addons/frontal/frontal_factor.hpp"
#include "addons/motion/register.hpp"
#include "addons/steps/steps.hpp"
#include "meshes/block.hpp"
#include "meshes/reshape.hpp"
#include "signorini/fem/strain_laws.hpp"
#include "signorini/pairing/interface.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;
using Eigen::Vector2d;

// 1. A slab of 12 mm by 4 mm, with eight times finer cells at its top than at its bottom.
Mesh slab() {
  return mapped(block("slab", {0, 0}, {12, 1}, 120, 6, MeshOrder::Quadratic),
                [](const Vector2d& x) -> Vector2d {
                  return {x.x(), 4 * (1 - std::pow(8, -x.y())) / (1 - 1.0 / 8)};
                });
}

// 2. A die 1.2 mm wide, below it an arc of the radius 0.75 mm, 0.2 mm above the slab.
Mesh die() {
  Mesh die = mapped(block("die", {-1, 0}, {2, 1}, 12, 4, MeshOrder::Quadratic),
                    [](const Vector2d& x) -> Vector2d {
                      const double angle = std::asin(0.8) * x.x();
                      const Vector2d arc(0.75 * std::sin(angle), 0.75 * (1 - std::cos(angle)));
                      const Vector2d top(0.6 * x.x(), 1.2);
                      return Vector2d(0.8, 4.2) + (1 - x.y()) * arc + x.y() * top;
                    });
  for (const char* side : {"left", "bottom", "right"})
    for (const CellSide& one : boundary(die, side)) die.boundaries["face"].push_back(one);
  return die;
}

Body neo_hookean(Mesh mesh, double youngs_modulus) {
  Body body;
  body.mesh = std::move(mesh);
  body.element = "q8";
  body.material = {youngs_modulus, 0.32, PlaneState::Strain, 1};
  body.material.law = find_strain_law("neo_hooke");
  return body;
}

// 3. Down by 1 mm in 20 steps, along by 5 mm in 50. The slab is the soft and fine side: the source.
Scene ironing() {
  Scene scene;
  scene.bodies = {neo_hookean(slab(), 689.6), neo_hookean(die(), 6896)};
  scene.bodies[0].supports = {fixed("bottom")};
  scene.bodies[1].supports = {prescribed("top", Axis::X, 5), prescribed("top", Axis::Y, -1)};
  scene.bodies[1].supports[0].history = "drag";
  scene.bodies[1].supports[1].history = "press";
  scene.contacts = {{{"top", "slab"}, Side{"face", "die"}}};
  scene.contacts[0].friction = Friction{0.3};
  std::vector<double> times = equal_steps(20);
  for (const double time : equal_steps(50)) times.push_back(1 + time);
  scene.path = Path{times, {{"press", {0, 1}, {0, 1}}, {"drag", {1, 2}, {0, 1}}}};
  return scene;
}

// 4. The forces where the die is down, and where it has gone along.
SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch22_published");
  const PathEnd end = solve_steps(ironing(), [&](const Model& model, const Step& step) {
    const Vector2d force = contact_forces(model, step.solution, 1).colwise().sum().transpose();
    const double time = step.state.time;
    if (time != 1 && time != 2) return;
    results.add(time == 1 ? "press_down" : "press_along", std::abs(force.y()), "N");
    results.add(time == 1 ? "drag_down" : "drag_along", std::abs(force.x()), "N");
  });
  results.add("steps_halved", double(end.halvings), "-");
  results.print();
  results.write(run.out);
  return end.status;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch22_published", "A published ironing", SIGNORINI_CHAPTER_OUT, argc,
                                argv, chapter);
}

// Contact of elastic bodies: the compliances that the chapters condense, a half-plane, a string.
#include "papers/solver_table.hpp"
#include "signorini/core/errors.hpp"
#include "meshes/block.hpp"
#include "signorini/scene/scene.hpp"
#include "support/cantilever.hpp"
#include "support/classes/classes.hpp"
#include "support/lining.hpp"
#include "support/pin.hpp"
#include "support/problems.hpp"

namespace signorini_test {
namespace {

using namespace signorini;
using Eigen::Index;

Instance condensed(std::string name, const Scene& scene) {
  Ledger ledger;
  return {std::move(name), condense(build(scene, ledger), ledger).problem};
}

/// With the forces that trying all sets of closed pairs finds.
Instance enumerated(Instance made) {
  made.force = find_solver("enumerate").solve(made.problem, {}).force;
  made.accuracy = 1e-9;
  return made;
}

}  // namespace

Instances block_on_obstacle() {  // chapter 1: rubber, 40 mm x 20 mm, pressed on a disc of 60 mm
  Instances made;
  for (const Index cells : {4, 8, 10, 32, 64})
    for (const double push : {0.05, 1.0}) {
      Scene scene;
      Body& body = scene.bodies[0];
      body.mesh = block("block", {-20, 0}, {40, 20}, cells, cells / 2);
      body.material = {10, 0.3, PlaneState::Strain, 1};
      body.supports = {prescribed("top", Axis::X, 0.0), prescribed("top", Axis::Y, -push)};
      scene.contacts = {{{"bottom"}, disc({0, -60}, 60)}};
      made.push_back(condensed(text(cells, " cells, pushed by ", push), scene));
    }
  return made;
}

Instances cantilever_on_foundation() {  // chapter 6: nothing, the tip, or a part of a line touches
  Instances made;
  for (const char* element : {"q4", "q4_incompatible", "q8"})
    for (const Index cells : {10, 40, 100})
      for (const double pressure : {0.4, 1.0, 3.6})
        made.push_back(condensed(text(element, ", ", cells, " cells, pressure ", pressure),
                                 cantilever(element, cells, cells / 10, pressure)));
  return made;
}

Instances pin_in_hole_of_a_plate() {  // chapter 7: both readings of the load
  Instances made;
  for (const double pressure : {-25.0, 25.0, 1.0})
    for (const Index cells : {6, 15, 40})
      made.push_back({text(cells, " cells, pressure ", pressure), pin_problem(pressure, cells)});
  for (const double pressure : {-25.0, 25.0})
    made.push_back(enumerated({text("9 cells, pressure ", pressure), pin_problem(pressure, 9)}));
  return made;
}

Instances lining_in_rock() { return {enumerated(condensed("paper's mesh", scene_of({})))}; }

Instances half_plane() {
  Instances made;
  for (const Punch punch : {Punch::Parabola, Punch::Flat})
    for (const Index n : {2, 11, 50, 200})
      made.push_back({text(punch == Punch::Flat ? "flat" : "parabola", ", ", n, " pairs"),
                      half_plane_indentation(n, punch).problem});
  return made;
}

Instances half_plane_large() {
#ifdef NDEBUG
  const Index n = 1000;
#else
  const Index n = 250;  // without optimisation, cubes are slow
#endif
  return {{text("parabola, ", n, " pairs"), half_plane_indentation(n).problem}};
}

Instances string_over_wave() {
  Instances made;
  for (const Index n : {10, 80}) made.push_back({text(n, " pairs"), string_problem(n)});
  return made;
}

}  // namespace signorini_test

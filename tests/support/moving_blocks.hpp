// A block that is pressed on a longer one and dragged along it, in steps.
#pragma once
#include "addons/steps/steps.hpp"
#include "meshes/block.hpp"

namespace signorini_test {

/// What may be chosen of such a scene.
struct MovingBlocks {
  double friction = 0.3;
  double stiffness = 1000;       ///< of the base; the block has 1000
  Eigen::Index base_cells = 24;  ///< along its length 6
  Eigen::Index cells = 5;        ///< of the block, along each side of length 1
  double press = 0.01;           ///< by how much the top of the block is moved down
  double drag = 3;               ///< and then along
  int steps = 12;                ///< of the drag
  signorini::MeshOrder order = signorini::MeshOrder::Linear;
  signorini::PlaneState state = signorini::PlaneState::Strain;
};

/// The top of the block is moved down in one step, then to the right.
inline signorini::Scene moving_blocks(const MovingBlocks& of = {}) {
  using namespace signorini;
  Scene scene;
  scene.bodies.resize(2);
  Body& base = scene.bodies[0];
  base.mesh = block("base", {0, 0}, {6, 1}, of.base_cells, 4, of.order);
  base.material = {of.stiffness, 0.3, of.state, 1};
  base.supports = {fixed("bottom")};
  Body& top = scene.bodies[1];
  top.mesh = block("block", {1, 1}, {1, 1}, of.cells, of.cells, of.order);
  top.material = {1000, 0.3, of.state, 1};
  top.supports = {prescribed("top", Axis::X, of.drag), prescribed("top", Axis::Y, -of.press)};
  top.supports[0].history = "drag";
  top.supports[1].history = "press";
  scene.contacts = {{{"bottom", "block"}, Side{"top", "base"}}};
  if (of.friction > 0) scene.contacts[0].friction = Friction{of.friction, 0};
  std::vector<double> times = {1};
  for (const double time : equal_steps(of.steps)) times.push_back(1 + time);
  scene.path = Path{times, {{"press", {0, 1}, {0, 1}}, {"drag", {1, 2}, {0, 1}}}};
  scene.moves = true;
  return scene;
}

}  // namespace signorini_test

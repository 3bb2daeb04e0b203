// Chapter 1 - The rubber block, for the programs that solve it.
#pragma once
#include "meshes/block.hpp"
#include "signorini/scene/scene.hpp"

namespace ch01 {

using namespace signorini;

/// A block, 40 mm x 20 mm, whose top is pressed down by 1 mm onto a round obstacle.
// [scene]
const double radius = 60;  // of the obstacle [mm]

inline Scene block_on_obstacle(Eigen::Index cells_x) {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = block("block", {-20, 0}, {40, 20}, cells_x, cells_x / 2);
  body.material = {/*E [N/mm^2]*/ 10, /*nu*/ 0.3, PlaneState::Strain, /*thickness [mm]*/ 1};
  body.supports = {prescribed("top", Axis::X, 0.0), prescribed("top", Axis::Y, -1.0)};
  scene.contacts = {{{"bottom"}, disc({0, -radius}, radius)}};
  return scene;
}
// [scene]

}  // namespace ch01

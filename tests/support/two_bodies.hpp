// Two blocks on each other as a scene, with the step to a solution.
#pragma once
#include <string>
#include <utility>

#include "meshes/block.hpp"
#include "signorini/scene/readings.hpp"

namespace signorini_test {

inline signorini::Mesh named_block(const std::string& name, Eigen::Vector2d corner,
                                   Eigen::Vector2d size, Eigen::Index nx, Eigen::Index ny,
                                   signorini::MeshOrder order = signorini::MeshOrder::Linear) {
  return signorini::block(name, corner, size, nx, ny, order);
}

/// Two blocks of one material, the bottom of `upper` on the top of `lower`, which stands on its fixed bottom.
inline signorini::Scene two_blocks(signorini::Mesh lower, signorini::Mesh upper) {
  using namespace signorini;
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].mesh = std::move(lower);
  scene.bodies[1].mesh = std::move(upper);
  for (Body& body : scene.bodies) body.material = {1000, 0.3, PlaneState::Strain, 1};
  scene.bodies[0].supports = {fixed("bottom")};
  scene.contacts = {{{"bottom", "upper"}, Side{"top", "lower"}}};
  return scene;
}

}  // namespace signorini_test

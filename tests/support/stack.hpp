// Blocks on top of each other, most of which contact alone holds.
#pragma once
#include <string>
#include <utility>

#include "signorini/scene/scene.hpp"
#include "support/facing_blocks.hpp"

namespace signorini_test {

/// Blocks of 4 by 1 on top of each other, the lowest one held. Without friction the others stand on rollers at the left, with
/// it contact alone holds them. The top one is pressed, more so at the right, and pushed aside where friction holds it.
inline signorini::Scene stack(int blocks, double friction) {
  using namespace signorini;
  Scene scene;
  scene.bodies.clear();
  for (int i = 0; i < blocks; ++i) {
    Body body;
    const auto name = [](int k) { return "block " + std::to_string(k); };
    body.mesh = block({0.0, static_cast<double>(i)}, {4, 1}, 4);
    body.mesh.name = name(i);
    body.material = {1000, 0.3};
    if (i == 0) body.supports = {fixed("bottom")};
    if (i > 0 && friction == 0) body.supports = {symmetric("left")};
    if (i == blocks - 1) body.loads.edges = {{"top", 1, {}}};
    scene.bodies.push_back(std::move(body));
    if (i == 0) continue;
    ContactSpec contact;
    contact.source = {"bottom", name(i)};
    contact.target = Side{"top", name(i - 1)};
    if (friction > 0) contact.friction = Friction{friction};
    scene.contacts.push_back(std::move(contact));
  }
  scene.bodies.back().loads.points = {
      {{4, static_cast<double>(blocks)}, {0.1 * friction, -0.3}}};
  return scene;
}

}  // namespace signorini_test

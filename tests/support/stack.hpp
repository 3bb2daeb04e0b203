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

/// A wall of n courses of n bricks of 1 by 1/2, shifted by half a brick from course to course, with friction, under its weight. The
/// lowest course is held.
inline signorini::Scene brick_wall(int n, double friction) {
  using namespace signorini;
  Scene scene;
  scene.bodies.clear();
  const auto name = [](int course, int brick) {
    return "brick " + std::to_string(course) + " " + std::to_string(brick);
  };
  for (int course = 0; course < n; ++course)
    for (int brick = 0; brick < n; ++brick) {
      Body body;
      body.mesh = block({brick + (course % 2 == 0 ? 0 : 0.5), 0.5 * course}, {1, 0.5}, 4);
      body.mesh.name = name(course, brick);
      body.material = {1000, 0.3};
      body.loads.body_force = [](const Eigen::Vector2d&) { return Eigen::Vector2d(0, -0.1); };
      if (course == 0) body.supports = {fixed("bottom")};
      scene.bodies.push_back(std::move(body));
      for (const int below : {brick - (course % 2 == 0 ? 1 : 0), brick + (course % 2 == 0 ? 0 : 1)}) {
        if (course == 0 || below < 0 || below >= n) continue;
        ContactSpec contact;
        contact.source = {"bottom", name(course, brick)};
        contact.target = Side{"top", name(course - 1, below)};
        contact.friction = Friction{friction};
        scene.contacts.push_back(std::move(contact));
      }
    }
  return scene;
}

}  // namespace signorini_test

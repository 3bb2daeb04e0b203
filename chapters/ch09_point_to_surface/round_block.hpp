/// \file
/// A block with a round underside, pushed into a flat one, in any units.
#pragma once
#include "meshes/block.hpp"
#include "meshes/reshape.hpp"
#include "signorini/scene/scene.hpp"
#include "signorini/solvers/fischer_burmeister.hpp"

namespace ch09 {

using namespace signorini;
using Eigen::Index;
using Eigen::Vector2d;

/// What lengths and forces are counted in.
struct Units {
  const char* name;
  double length = 1;  ///< a mm is so many of them
  double force = 1;   ///< and a N so many of those
};

/// A block with a round underside, pushed into a flat one: mm, N, E = 1000 and 2000 MPa.
/// \param n      cells of the upper block across; both have n x n/2 and 5n/4 x n/2 cells
/// \param units  other units for the same bodies
inline Scene round_block(Index n, const Units& units) {
  const double L = units.length, stress = units.force / (L * L);
  Scene scene;
  scene.bodies.resize(2);
  Body& lower = scene.bodies[0];
  Body& upper = scene.bodies[1];
  lower.mesh = block("lower", {-12 * L, -10 * L}, {24 * L, 10 * L}, 5 * n / 4, n / 2);
  upper.mesh = mapped(block("upper", {-10 * L, 0}, {20 * L, 10 * L}, n, n / 2),
                      [L](const Vector2d& x) -> Vector2d {  // radius 200 at the bottom
                        const double rise = x.x() * x.x() / (400 * L);
                        return {x.x(), x.y() + rise * (1 - x.y() / (10 * L))};
                      });
  lower.material = {1000 * stress, 0.3, PlaneState::Strain, L};
  upper.material = {2000 * stress, 0.3, PlaneState::Strain, L};
  lower.supports = {fixed("bottom")};
  upper.supports = {prescribed("top", Axis::Y, -0.1 * L), prescribed("top", Axis::X, 0)};
  scene.contacts = {{}};
  scene.contacts[0].source = {"bottom", "upper"};
  scene.contacts[0].target = Side{"top", "lower"};
  scene.contacts[0].gap_operator = "node_to_segment";
  scene.solver = signorini::fischer_burmeister();  // the member, not the function of two numbers
  return scene;
}

}  // namespace ch09

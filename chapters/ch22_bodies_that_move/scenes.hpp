// Chapter 22 - The two scenes of the chapter: a block that is dragged, and a die that irons.
#pragma once
#include <cmath>

#include "loop.hpp"
#include "meshes/block.hpp"
#include "meshes/reshape.hpp"

namespace ch22 {

const double modulus = 1000;  // of the softer body [N/mm^2]
const double mu = 0.3;

/// A body that is held where its hand or the ground is.
inline Body held(Mesh mesh, double youngs_modulus, const char* side) {
  Body body;
  body.mesh = std::move(mesh);
  body.material = {youngs_modulus, 0.3, PlaneState::Strain, 1};
  body.supports = {fixed(side)};
  return body;
}

/// A block of 1 mm by 1 mm on a base of 6 mm by 1 mm, with cells that do not match.
/// \param stiff  modulus of the base over that of the block
inline Two blocks(double stiff, Index fine = 1) {
  return {held(block("base", {0, 0}, {6, 1}, 24 * fine, 4 * fine), stiff * modulus, "bottom"),
          held(block("block", {0.637, 1}, {1, 1}, 5 * fine, 5 * fine), modulus, "top"), "bottom",
          mu};
}

/// A die with a round side of radius 1 mm on a slab of 4 mm by 1 mm, which is ten times as soft.
inline Two ironing(const char* gap_operator, Index fine) {
  const auto round = [](const Vector2d& x) -> Vector2d {
    const double angle = 0.5 * x.x();
    const Vector2d arc(std::sin(angle), 1 - std::cos(angle)), top(std::sin(0.5) * x.x(), 0.6);
    return Vector2d(1.5, 0) + (1 - x.y()) * arc + x.y() * top;
  };
  return {held(block("slab", {0, -1}, {4, 1}, 32 * fine, 8 * fine), modulus, "bottom"),
          held(mapped(block("die", {-1, 0}, {2, 1}, 10 * fine, 6 * fine), round), 10 * modulus,
               "top"),
          "bottom", mu, gap_operator};
}

/// Nothing has moved.
inline NodeArray at_rest(const Assembled& bodies) {
  return NodeArray::Zero(bodies.model.unknowns.number.rows(), 2);
}

/// What contact does to the tool: pushes and drags of all pairs [N].
inline Vector2d force_on_tool(const Place& place) {
  Vector2d sum(0, 0);
  for (Index pair = 0; pair < place.contact.force.size(); ++pair) {
    const Vector2d n = place.gaps.pairs.normal.row(pair).transpose();
    sum += place.contact.force(pair) * n;
    if (place.contact.friction.size() > 0)
      sum += place.contact.friction(pair) * Vector2d(n.y(), -n.x());
  }
  return sum;
}

}  // namespace ch22

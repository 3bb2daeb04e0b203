// Scenes in another place, whose coordinates are as exact there as they were before.
#pragma once
#include <algorithm>
#include <cmath>
#include <utility>

#include "signorini/mesh/reshape.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini_test {

/// The size of the largest body: the diagonal of its box.
inline double size_of(const signorini::Scene& scene) {
  double size = 0;
  for (const signorini::Body& body : scene.bodies) {
    const signorini::NodeArray& x = body.mesh.nodes;
    size = std::max(size, (x.colwise().maxCoeff() - x.colwise().minCoeff()).norm());
  }
  return size;
}

inline Eigen::Vector2d rounded(const Eigen::Vector2d& x, double grid) {
  return {std::round(x.x() / grid) * grid, std::round(x.y() / grid) * grid};
}

/// The mesh with nodes on multiples of `grid`, a power of two.
inline signorini::Mesh on_grid(signorini::Mesh mesh, double grid) {
  return mapped(std::move(mesh), [grid](const Eigen::Vector2d& x) { return rounded(x, grid); });
}

/// The scene with nodes and supported points on multiples of `grid`.
inline signorini::Scene on_grid(signorini::Scene scene, double grid) {
  for (signorini::Body& body : scene.bodies) {
    body.mesh = on_grid(std::move(body.mesh), grid);
    for (signorini::Support& support : body.supports)
      if (support.only_at) support.only_at = rounded(*support.only_at, grid);
  }
  return scene;
}

/// The scene in another place. Displacements that are given and loads must not depend on the place.
inline signorini::Scene moved(signorini::Scene scene, const Eigen::Vector2d& shift) {
  for (signorini::Body& body : scene.bodies) {
    body.mesh = signorini::moved(std::move(body.mesh), shift);
    for (signorini::Support& support : body.supports)
      if (support.only_at) *support.only_at += shift;
    for (signorini::Spring& spring : body.springs)
      if (spring.only_at) *spring.only_at += shift;
    for (signorini::PointForce& load : body.loads.points) load.point += shift;
  }
  for (signorini::ContactSpec& contact : scene.contacts)
    if (auto* const obstacle = std::get_if<signorini::Obstacle>(&contact.target))
      obstacle->look = [look = obstacle->look, shift](const Eigen::Vector2d& x) {
        return look(x - shift);
      };
  return scene;
}

}  // namespace signorini_test

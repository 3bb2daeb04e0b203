// Scenes in another place, whose coordinates are as exact there as they were before.
#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "signorini/core/dense.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/fem/far.hpp"
#include "meshes/reshape.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/rigid_modes.hpp"

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

/// Whether a scene depends on directions that rounding of its coordinates hides in another place: what a row says of an
/// unknown is less there than some roundings, or how far motions move a pair less than sixty of two sides.
inline bool hidden(const signorini::Scene& scene, const Eigen::Vector2d& shift) {
  double rounding = 0;
  for (const signorini::Body& body : scene.bodies)
    rounding = std::max(rounding, direction_rounding(signorini::moved(body.mesh, shift)));
  const signorini::Plan planned = plan(scene);
  const signorini::NodalRows rows = contact_rows(planned.gaps, planned.law);
  for (Eigen::Index row = 0; row < rows.rows(); ++row) {
    const Eigen::VectorXd entries = Eigen::VectorXd(rows.row(row)).cwiseAbs();
    if ((entries.array() > 0 && entries.array() <= 8 * rounding * entries.maxCoeff()).any())
      return true;
  }
  const Eigen::MatrixXd moves = signorini::rigid_gaps(rows, mode_entries(planned.modes));
  if (moves.size() == 0) return false;
  // Of single pairs, and of motions that hold each other but for so little.
  const auto little = [&](const Eigen::ArrayXd& much, double nothing) {
    const double most = 256 * rounding * static_cast<double>(moves.cols());
    return (much > nothing && much <= most).any();
  };
  return little(moves.cwiseAbs().reshaped().array(), 0) ||
         little(signorini::singular_values(moves).values.array(), 64 * signorini::epsilon);
}

/// The scene turned by a quarter, anticlockwise about the origin, as those turn it who do not know that it is one: the cosine of 90
/// degrees is 6e-17. Without springs and temperature.
inline signorini::Scene quarter_turned(signorini::Scene scene) {
  const Eigen::Rotation2D<double> turn(signorini::pi / 2);
  const auto turned = [turn](const signorini::VectorField& field) -> signorini::VectorField {
    if (!field) return {};
    return [=](const Eigen::Vector2d& x) { return turn * field(turn.inverse() * x); };
  };
  for (signorini::Body& body : scene.bodies) {
    body.mesh = mapped(std::move(body.mesh),
                       [turn](const Eigen::Vector2d& x) -> Eigen::Vector2d { return turn * x; });
    for (signorini::Support& support : body.supports) {
      std::swap(support.holds_x, support.holds_y);
      support.displacement = turned(support.displacement);
      if (support.only_at) support.only_at = turn * *support.only_at;
    }
    body.loads.body_force = turned(body.loads.body_force);
    for (signorini::EdgeLoad& load : body.loads.edges) load.traction = turned(load.traction);
    for (signorini::PointForce& load : body.loads.points) {
      load.point = turn * load.point;
      load.force = turn * load.force;
    }
  }
  for (signorini::ContactSpec& contact : scene.contacts)
    if (auto* const obstacle = std::get_if<signorini::Obstacle>(&contact.target))
      obstacle->look = [look = obstacle->look, turn](const Eigen::Vector2d& x) {
        signorini::ObstacleContact seen = look(turn.inverse() * x);
        seen.normal = turn * seen.normal;
        return seen;
      };
  return scene;
}

}  // namespace signorini_test

// Two blocks above each other that a tie holds together.
#pragma once
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "addons/equations/bonds.hpp"
#include "meshes/split.hpp"
#include "meshes/block.hpp"
#include "meshes/reshape.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/scene/readings.hpp"

namespace stacked_blocks {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;
using namespace signorini;

/// A length and a modulus in other units.
struct Units {
  double length = 1;
  double stress = 1;
};

inline Mesh block_of(const std::string& element, const std::string& name, const Vector2d& corner,
              const Vector2d& size, Index nx, Index ny) {
  const bool quadratic = element == "q8" || element == "t6";
  const Mesh mesh =
      block(name, corner, size, nx, ny, quadratic ? MeshOrder::Quadratic : MeshOrder::Linear);
  return element[0] == 't' ? split(mesh) : mesh;
}

inline Body body_of(Mesh mesh, const std::string& element, const Material& material) {
  Body body;
  body.mesh = std::move(mesh);
  body.element = element;
  body.material = material;
  return body;
}

inline Mesh turned_by(double angle, const Mesh& mesh) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return mapped(mesh, [=](const Vector2d& x) {
    return Vector2d(c * x.x() - s * x.y(), s * x.x() + c * x.y());
  });
}

inline Tie tie_of(const Side& source, std::variant<Obstacle, Side> target, bool slides = false) {
  Tie tie;
  tie.sides.source = source;
  tie.sides.target = std::move(target);
  tie.slides = slides;
  return tie;
}

inline std::shared_ptr<const Bonds> bonds_of(std::vector<Tie> ties) {
  return std::make_shared<const Bonds>(Bonds{std::move(ties)});
}

/// Two blocks above each other whose meshes do not match, the upper one the source.
inline Scene stack(const std::string& element, const Units& unit = {}, double gap = 0) {
  Scene scene;
  const Material material{1000 * unit.stress, 0.3, PlaneState::Strain, unit.length};
  const double l = unit.length;
  scene.bodies = {
      body_of(block_of(element, "lower", {0, 0}, l * Vector2d(6, 2), 5, 2), element, material),
      body_of(block_of(element, "upper", l * Vector2d(0, 2 + gap), l * Vector2d(6, 2), 3, 2),
              element, material)};
  scene.bonds = bonds_of({tie_of({"bottom", "upper"}, Side{"top", "lower"})});
  return scene;
}

/// Loads every side of a stack but those that are tied with the traction of a stress, and holds three components.
inline void load_uniformly(const Vector3d& stress, double angle, Scene& scene) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const auto pull = [&](const std::string& side, const Vector2d& n) {
    const Vector2d out(c * n.x() - s * n.y(), s * n.x() + c * n.y());
    const Vector2d t(stress(0) * out.x() + stress(2) * out.y(),
                     stress(2) * out.x() + stress(1) * out.y());
    EdgeLoad load;
    load.boundary = side;
    load.traction = [t](const Vector2d&) { return t; };
    return load;
  };
  scene.bodies[0].loads.edges = {pull("left", {-1, 0}), pull("right", {1, 0}),
                                 pull("bottom", {0, -1})};
  scene.bodies[1].loads.edges = {pull("left", {-1, 0}), pull("right", {1, 0}),
                                 pull("top", {0, 1})};
  const Mesh& mesh = scene.bodies[0].mesh;
  const std::vector<Index> bottom = boundary_nodes(mesh, "bottom");
  const Vector2d first = mesh.nodes.row(bottom.front()).transpose();
  const Vector2d last = mesh.nodes.row(bottom.back()).transpose();
  const Axis across = std::abs(c) > std::abs(s) ? Axis::Y : Axis::X;
  scene.bodies[0].supports = {prescribed_at("bottom", first, Axis::X),
                              prescribed_at("bottom", first, Axis::Y),
                              prescribed_at("bottom", last, across)};
}

inline double stress_error(const SolvedScene& run, const Vector3d& stress) {
  double worst = 0;
  for (std::size_t b = 0; b < run.model.bodies.size(); ++b) {
    const BodyModel& body = run.model.bodies[b];
    const StressArray found =
        cell_stress(body.mesh, body.element, body.material, run.solution.displacements[b]);
    worst = std::max(worst, (found.leftCols(3).rowwise() - stress.transpose()).cwiseAbs().maxCoeff());
  }
  return worst / stress.cwiseAbs().maxCoeff();
}

inline double largest_displacement(const Solution& solution) {
  double most = 0;
  for (const NodeArray& u : solution.displacements) most = std::max(most, u.cwiseAbs().maxCoeff());
  return most;
}

inline const std::vector<std::string> all_elements = {"q4", "q4_bbar", "q4_incompatible", "q8", "t3", "t6"};

}  // namespace stacked_blocks

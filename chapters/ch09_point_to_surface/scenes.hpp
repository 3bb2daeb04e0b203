/// \file
/// Two blocks, one on the other: under uniform pressure, beside a corner, and with a round underside.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "signorini/mesh/block.hpp"
#include "signorini/mesh/reshape.hpp"
#include "signorini/report/shown.hpp"
#include "signorini/scene/readings.hpp"

namespace ch09 {

using namespace signorini;
using Eigen::Index;
using Eigen::Vector2d;

/// A block of cells.
/// \param name    of the body
/// \param corner  lower left
/// \param size    width and height
/// \param x       cells along x
/// \param y       cells along y
inline Mesh cells(const char* name, const Vector2d& corner, const Vector2d& size, Index x,
                  Index y) {
  return block(name, corner, size, x, y);
}

/// Who carries the forces.
enum class Source { Upper, Lower };

/// Two blocks whose meshes do not match, pressed together. E = 1, nu = 0.3, plane strain.
/// \param upper   cells of the upper block along the interface
/// \param lower   cells of the lower one
/// \param source  which side it is
/// \param gap_operator  of the contact
// [patch]
inline Scene patch(Index upper, Index lower, Source source, const std::string& gap_operator) {
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].mesh = cells("lower", {0, 0}, {2, 1}, lower, 3);
  scene.bodies[1].mesh = cells("upper", {0, 1}, {2, 1}, upper, 3);
  for (Body& body : scene.bodies) {
    body.element = "q4";
    body.material.poisson_ratio = 0.3;
    body.loads.edges = {{"left", 0.01, {}}, {"right", 0.01, {}}};  // the same pressure on all sides
  }
  scene.bodies[0].supports = {prescribed("bottom", Axis::Y, 0),
                              prescribed_at("bottom", {0, 0}, Axis::X)};
  scene.bodies[1].supports = {prescribed_at("top", {0, 2}, Axis::X)};  // contact must hold the rest
  scene.bodies[1].loads.edges.push_back({"top", 0.01, {}});
  const Side over{"bottom", "upper"}, under{"top", "lower"};
  scene.contacts = {{}};
  scene.contacts[0].source = source == Source::Upper ? over : under;
  scene.contacts[0].target = source == Source::Upper ? under : over;
  scene.contacts[0].gap_operator = gap_operator;
  return scene;
}
// [patch]

/// A wide block on a narrow one: the corners of the narrow one lie between nodes of the wide one.
/// \param upper   cells of the upper block, 3 wide; the lower one is 2 wide with 20 cells
/// \param source  which side it is
/// \param gap_operator  of the contact
// [corner]
inline Scene corner(Index upper, Source source, const std::string& gap_operator) {
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].mesh = cells("lower", {0.5, 0}, {2, 1}, 20, 10);
  scene.bodies[1].mesh = cells("upper", {0, 1}, {3, 1}, upper, 3);
  scene.bodies[0].supports = {fixed("bottom")};
  scene.bodies[1].supports = {prescribed("top", Axis::Y, -0.01),
                              prescribed_at("top", {0, 2}, Axis::X)};
  const Side over{"bottom", "upper"}, under{"top", "lower"};
  scene.contacts = {{}};
  scene.contacts[0].source = source == Source::Upper ? over : under;
  scene.contacts[0].target = source == Source::Upper ? under : over;
  scene.contacts[0].gap_operator = gap_operator;
  return scene;
}
// [corner]

/// How deep the two lines of nodes of a level interface lie inside each other, at the nodes of either.
/// \param scene  with the bodies "lower" and "upper"
/// \param run    its solution
/// \return largest overlap [length]
inline double overlap(const Scene& scene, const SolvedScene& run) {
  struct Line {
    std::vector<double> x, y;  // x of the nodes as drawn, y as displaced, from left to right
    double at(double place) const {
      std::size_t k = 1;
      while (k + 1 < x.size() && x[k] < place) ++k;
      const double s = (place - x[k - 1]) / (x[k] - x[k - 1]);
      return (1 - s) * y[k - 1] + s * y[k];
    }
  };
  const auto line = [&](std::size_t body, const char* side) {
    Line found;
    const Mesh& mesh = scene.bodies[body].mesh;
    std::vector<Index> nodes = boundary_nodes(mesh, side);
    if (mesh.nodes(nodes.front(), 0) > mesh.nodes(nodes.back(), 0))
      std::reverse(nodes.begin(), nodes.end());
    for (const Index node : nodes) {
      found.x.push_back(mesh.nodes(node, 0));
      found.y.push_back(mesh.nodes(node, 1) + run.solution.displacements[body](node, 1));
    }
    return found;
  };
  const Line lower = line(0, "top"), upper = line(1, "bottom");
  double deepest = 0;
  for (const Line* nodes : {&lower, &upper})
    for (const double x : nodes->x) {
      const bool both = std::min(lower.x.back(), upper.x.back()) >= x &&
                        std::max(lower.x.front(), upper.x.front()) <= x;
      if (both) deepest = std::max(deepest, lower.at(x) - upper.at(x));
    }
  return deepest;
}

/// What became of a uniform pressure.
struct Pressed {
  double deviation;  ///< largest |pressure / uniform - 1|
  double overlap;    ///< over the compression of both blocks
};

/// Solves a patch test; arguments as for patch().
inline Pressed pressed(Index upper, Index lower, Source source, const char* gap_operator) {
  const Scene scene = patch(upper, lower, source, gap_operator);
  const SolvedScene run = shown(scene, "the patch test");
  const double compression = 2 * 1.3 * 0.4 * 0.01;  // height (1 + nu)(1 - 2 nu) p / E
  return {(run.solution.pressure.array() / 0.01 - 1).abs().maxCoeff(),
          overlap(scene, run) / compression};
}

/// What lengths and forces are counted in.
struct Units {
  const char* name;
  double length = 1;  ///< a mm is so many of them
  double force = 1;   ///< and a N so many of those
};

/// A block with a round underside, pushed into a flat one: mm, N, E = 1000 and 2000 MPa.
/// \param n      cells of the upper block across; both have n x n/2 and 5n/4 x n/2 cells
/// \param units  other units for the same bodies
// [round]
inline Scene round_block(Index n, const Units& units) {
  const double L = units.length, stress = units.force / (L * L);
  Scene scene;
  scene.bodies.resize(2);
  Body& lower = scene.bodies[0];
  Body& upper = scene.bodies[1];
  lower.mesh = cells("lower", {-12 * L, -10 * L}, {24 * L, 10 * L}, 5 * n / 4, n / 2);
  upper.mesh = mapped(cells("upper", {-10 * L, 0}, {20 * L, 10 * L}, n, n / 2),
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
  scene.solver = "fischer_burmeister";
  return scene;
}
// [round]

}  // namespace ch09

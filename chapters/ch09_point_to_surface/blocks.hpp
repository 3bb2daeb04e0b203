/// \file
/// Two blocks, one on the other, with either one as the source.
#pragma once
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "meshes/block.hpp"
#include "signorini/pairing/node_to_segment.hpp"  // the operators of these contacts, linked with it
#include "signorini/scene/readings.hpp"

namespace ch09 {

using namespace signorini;
using Eigen::Index;
using Eigen::Vector2d;

/// Who carries the forces.
enum class Source { Upper, Lower };

/// A block named "lower" and one named "upper", whose bottom lies on the top of the first. E = 1, plane strain.
/// \param lower         mesh of the first
/// \param upper         mesh of the second
/// \param source        which of them it is
/// \param gap_operator  of the contact
inline Scene blocks(Mesh lower, Mesh upper, Source source, const std::string& gap_operator) {
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].mesh = std::move(lower);
  scene.bodies[1].mesh = std::move(upper);
  const Side over{"bottom", "upper"}, under{"top", "lower"};
  scene.contacts = {{}};
  scene.contacts[0].source = source == Source::Upper ? over : under;
  scene.contacts[0].target = source == Source::Upper ? under : over;
  scene.contacts[0].gap_operator = gap_operator;
  return scene;
}

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

}  // namespace ch09

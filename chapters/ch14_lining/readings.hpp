/// \file
/// What the chapter reads off a solution: nodes, displacements of the rim, deviations.
#pragma once
#include <cmath>
#include <vector>

#include "signorini/scene/readings.hpp"

namespace ch14 {

using Eigen::Index;

/// The node of a body that is nearest to a place.
inline Index nearest(const signorini::Mesh& mesh, double radius, double angle) {
  Index node = 0;
  const Eigen::RowVector2d place(radius * std::cos(angle), radius * std::sin(angle));
  (mesh.nodes.rowwise() - place).rowwise().squaredNorm().minCoeff(&node);
  return node;
}

/// Displacements of the nodes of the inner rim, outwards [length].
inline Eigen::VectorXd inner_rim(const signorini::SolvedScene& run) {
  const std::vector<Index> nodes = boundary_nodes(run.model.bodies[0].mesh, "inner");
  Eigen::VectorXd u(static_cast<Index>(nodes.size()));
  for (Index k = 0; k < u.size(); ++k)
    u(k) = run.solution.displacements[0].row(nodes[static_cast<std::size_t>(k)]).norm();
  return u;
}

/// Deviation from a value that is known [%].
inline double percent(double value, double exact) { return 100 * (value / exact - 1); }

/// Pictures show the gap and all displacements so many times as large as they are.
const double magnified = 20;

/// A ring as it is drawn before loading: the rock is shifted outwards, so that the gap is magnified as well.
inline signorini::Mesh drawn(signorini::Mesh mesh, double gap) {
  if (mesh.name != "rock") return mesh;
  for (auto node : mesh.nodes.rowwise()) node *= 1 + (magnified - 1) * gap / node.norm();
  return mesh;
}

}  // namespace ch14

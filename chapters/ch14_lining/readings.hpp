/// \file
/// What the chapter reads off a solution: displacements of the rim, stresses in polar directions.
#pragma once
#include <cmath>
#include <vector>

#include "signorini/elasticity/stress.hpp"
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

/// Mean stresses of the cells of one body, in the directions of their middles.
struct CellStresses {
  Eigen::VectorXd
      radius;  ///< mean of the layer's [length]; the middle of a straight-sided cell is further in
  Eigen::VectorXd radial;  ///< [force/length^2], tension > 0
  Eigen::VectorXd hoop;    ///< [force/length^2], tension > 0
};

/// \param run what solved() made \param body its number \return stresses per cell
inline CellStresses cell_stresses(const signorini::SolvedScene& run, std::size_t body) {
  const signorini::BodyModel& model = run.model.bodies[body];
  const signorini::StressArray stress =
      cell_stress(model.mesh, model.element, model.material, run.solution.displacements[body]);
  const Index n = stress.rows();
  CellStresses out{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n)};
  for (Index cell = 0; cell < n; ++cell) {
    Eigen::RowVector2d middle(0, 0);
    for (Index k = 0; k < 4; ++k) middle += model.mesh.nodes.row(model.mesh.cells(cell, k)) / 4;
    const Index first = model.mesh.cells(cell, 0), opposite = model.mesh.cells(cell, 2);
    out.radius(cell) =
        (model.mesh.nodes.row(first).norm() + model.mesh.nodes.row(opposite).norm()) / 2;
    const Eigen::RowVector2d e = middle.normalized();
    out.radial(cell) = stress(cell, 0) * e.x() * e.x() + stress(cell, 1) * e.y() * e.y() +
                       2 * stress(cell, 2) * e.x() * e.y();
    out.hoop(cell) = stress(cell, 0) + stress(cell, 1) - out.radial(cell);
  }
  return out;
}

}  // namespace ch14

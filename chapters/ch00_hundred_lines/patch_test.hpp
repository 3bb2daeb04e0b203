// Chapter 0 - The patch test: cells of any shape carry a uniform strain exactly.
#pragma once
#include <algorithm>

#include "finite_elements.hpp"

namespace ch00 {

/// Nine cells in a square of side 3; the four nodes inside are moved out of place.
inline Mesh crooked_patch() {
  Mesh mesh = rectangle(3, 3, 3, 3);
  mesh.nodes.row(5) << 1.25, 0.75;
  mesh.nodes.row(6) << 1.75, 1.30;
  mesh.nodes.row(9) << 0.70, 2.20;
  mesh.nodes.row(10) << 2.20, 1.90;
  return mesh;
}

// [patch]
/// Gives the boundary of the square linear displacements x -> F x, and solves for the nodes inside.
inline VectorXd patch_test(const Mesh& mesh, const Matrix3d& D, const Matrix2d& F) {
  Held held;
  for (Index node = 0; node < mesh.nodes.rows(); ++node) {
    const Eigen::Vector2d x = mesh.nodes.row(node);
    if (x.minCoeff() > 0 && x.maxCoeff() < 3) continue;  // inside
    for (Index axis = 0; axis < 2; ++axis) held[2 * node + axis] = F.row(axis).dot(x);
  }
  return solve(assemble(mesh, D), VectorXd::Zero(2 * mesh.nodes.rows()), held);
}
// [patch]

/// The largest distance of a node from x -> F x.
inline double patch_error(const Mesh& mesh, const VectorXd& u, const Matrix2d& F) {
  double worst = 0;
  for (Index node = 0; node < mesh.nodes.rows(); ++node)
    worst = std::max(
        worst,
        (u.segment<2>(2 * node) - F * mesh.nodes.row(node).transpose()).cwiseAbs().maxCoeff());
  return worst;
}

}  // namespace ch00

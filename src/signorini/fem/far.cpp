// # Digits that are lost far from the origin
//
// A double has 16 digits wherever it is. A cell of size 1 at \f$x = 10^6\f$ has spent six of them
// on the distance, and each difference of two of its coordinates has ten left. The direction of a
// side of length \f$h\f$ is then uncertain by about \f$\epsilon\,x/h\f$, that is by
// \f$2\cdot10^{-10}\f$. Normals inherit it, and so do the questions whether a support stops a
// motion and whether two sides face each other. Tolerances that know nothing of it would answer
// differently when a user moves the drawing.

#include "signorini/fem/far.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "signorini/core/rounding.hpp"

namespace signorini {

using Eigen::Index;

/// The box counts, not the nodes: a body around the origin is not far from it, however large it is.
double distance_from_origin(const NodeArray& nodes) {
  const Eigen::RowVector2d low = nodes.colwise().minCoeff();
  const Eigen::RowVector2d high = nodes.colwise().maxCoeff();
  return low.cwiseMax(-high).cwiseMax(0).norm();
}

/// Chords will do: a bent side is longer, and what is asked is how short a side is.
double shortest_side(const Mesh& mesh, Index cell) {
  double shortest = std::numeric_limits<double>::infinity();  // its square
  const int corners = mesh.corners(cell);
  Index last = mesh.cells(cell, corners - 1);
  for (int k = 0; k < corners; ++k) {
    const Index next = mesh.cells(cell, k);
    shortest = std::min(shortest, (mesh.nodes.row(next) - mesh.nodes.row(last)).squaredNorm());
    last = next;
  }
  return std::sqrt(shortest);
}

/// The worst of both: the largest coordinate and the shortest side, even if they are not
/// neighbours.
double direction_rounding(const Mesh& mesh) {
  double shortest = std::numeric_limits<double>::infinity();
  for (Index cell = 0; cell < mesh.n_cells(); ++cell)
    shortest = std::min(shortest, shortest_side(mesh, cell));
  return epsilon * (1 + ratio(mesh.nodes.cwiseAbs().maxCoeff(), shortest));
}

}  // namespace signorini

#include "signorini/fem/far.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "signorini/core/rounding.hpp"

namespace signorini {

using Eigen::Index;

double distance_from_origin(const NodeArray& nodes) {
  const Eigen::RowVector2d low = nodes.colwise().minCoeff();
  const Eigen::RowVector2d high = nodes.colwise().maxCoeff();
  return low.cwiseMax(-high).cwiseMax(0).norm();
}

double direction_rounding(const Mesh& mesh) {
  double shortest = std::numeric_limits<double>::infinity();  // its square
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    const int corners = mesh.corners(cell);
    for (int k = 0; k < corners; ++k)
      shortest = std::min(shortest, (mesh.nodes.row(mesh.cells(cell, (k + 1) % corners)) -
                                     mesh.nodes.row(mesh.cells(cell, k)))
                                        .squaredNorm());
  }
  return epsilon * (1 + ratio(mesh.nodes.cwiseAbs().maxCoeff(), std::sqrt(shortest)));
}

}  // namespace signorini

#include "addons/along/place_in_mesh.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/fem/cells.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d;

constexpr double nowhere = std::numeric_limits<double>::infinity();

/// How far a place is beyond the sides of the reference cell; 0 within.
double beyond(const Element& element, const Vector2d& local) {
  const double farthest = element.corners() == 3
                              ? std::max({-local.x(), -local.y(), local.x() + local.y() - 1})
                              : local.cwiseAbs().maxCoeff() - 1;
  return std::max(0.0, farthest);
}

/// Solves N(local)' arms = 0 by Newton's method from the middle. \param arms  from the point to the nodes
/// \return whether it came to rest
bool invert(const Element& element, const CellNodes& arms, Vector2d& local) {
  constexpr int most = 30;
  local.setConstant(element.corners() == 3 ? 1.0 / 3 : 0);
  for (int k = 0; k < most; ++k) {
    const Shape shape = element.shape(local.x(), local.y());
    const Eigen::Matrix2d map = shape.slope.transpose() * arms;  // rows d/dxi, d/deta
    const Vector2d step = -map.transpose().inverse() * (arms.transpose() * shape.value);
    if (!step.allFinite()) return false;
    local += step;
    if (step.cwiseAbs().maxCoeff() < 1e-13) return true;
  }
  return false;
}

[[noreturn]] void refuse(const Mesh& mesh, const Vector2d& point) {
  Index nearest = 0;
  (mesh.nodes.rowwise() - point.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
  const auto place = [](const auto& x) {
    return text('(', shortest(x(0)), ", ", shortest(x(1)), ')');
  };
  throw ProblemError(text("the point ", place(point), " is not in '", mesh.name,
                          "': give one within its mesh, such as the nearest node ",
                          place(mesh.nodes.row(nearest))));
}

}  // namespace

PlaceInMesh place_in_mesh(const Mesh& mesh, const Element& element, const Vector2d& point) {
  const Element& triangle = element.corners() == 3 ? element : triangle_beside(mesh);
  PlaceInMesh found{{}, {}, nowhere};
  for (Index cell = 0; cell < mesh.n_cells() && found.outside > 0; ++cell) {
    const CellNodes arms = cell_nodes(mesh, cell).rowwise() - point.transpose();
    const Eigen::RowVector2d low = arms.colwise().minCoeff();
    const Eigen::RowVector2d high = arms.colwise().maxCoeff();
    // Curved sides bulge out of the box of the nodes, by less than half of its size.
    const Eigen::RowVector2d around = (high - low) / 2;
    if (((low - around).array() > 0).any() || ((high + around).array() < 0).any()) continue;
    const Element& own = mesh.corners(cell) == 3 ? triangle : element;
    Vector2d local;
    if (!invert(own, arms, local)) continue;
    const double outside = beyond(own, local);
    if (!(outside < found.outside)) continue;
    found.outside = outside;
    found.share = own.shape(local.x(), local.y()).value;
    found.nodes.clear();
    for (Index k = 0; k < own.n_nodes; ++k) found.nodes.push_back(mesh.cells(cell, k));
  }
  return found;
}

bool is_outside(const PlaceInMesh& place) { return place.outside > 1e-6; }

PlaceInMesh place_within(const Mesh& mesh, const Element& element, const Vector2d& point) {
  PlaceInMesh place = place_in_mesh(mesh, element, point);
  if (is_outside(place)) refuse(mesh, point);
  return place;
}

}  // namespace signorini

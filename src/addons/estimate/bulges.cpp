#include "addons/estimate/bulges.hpp"

#include <cmath>

#include "addons/estimate/outline_shape.hpp"
#include "signorini/fem/joints.hpp"
#include "signorini/fem/side_curve.hpp"

namespace signorini {

using Eigen::Index, Eigen::Vector2d;

std::map<Index, std::vector<Bulge>> bulges(const Mesh& mesh) {
  std::map<Index, std::vector<Bulge>> of_cell;
  const OutlineShape shape(mesh);
  for (const CellSide& side : outer_sides(mesh)) {
    const SideCurve curve(mesh, side);
    const std::size_t ways = curve.nodes().size() - 1;
    Bulge bulge{side, {}};
    bool leaves = false;
    for (std::size_t k = 0; k < ways; ++k) {
      const double xi = ways == 1 ? 0 : static_cast<double>(k) - 0.5;
      const Vector2d middle = shape.middle(curve.nodes()[k], curve.nodes()[k + 1]);
      bulge.rise.push_back((AnchoredPoint(middle) - curve.point(xi)).dot(curve.normal(xi)));
      leaves = leaves || bulge.rise.back() != 0;
    }
    if (leaves) of_cell[side.cell].push_back(bulge);
  }
  return of_cell;
}

std::vector<Beside> places_beside(const Cell& cell, const Bulge& bulge) {
  std::vector<Beside> places;
  const SideCurve curve(cell.mesh, bulge.side);
  const CellNodes corners = reference_nodes(cell.element);
  const Eigen::RowVector2d first = corners.row(bulge.side.side);
  const Eigen::RowVector2d last = corners.row((bulge.side.side + 1) % cell.element.corners());
  const auto ways = static_cast<double>(bulge.rise.size());
  for (std::size_t k = 0; k < bulge.rise.size(); ++k)
    for (const GaussPoint& gauss : gauss_line(2)) {
      const double xi = (gauss.xi + 2 * static_cast<double>(k) + 1) / ways - 1;
      const Vector2d local = ((1 - xi) * first + (1 + xi) * last) / 2;
      Beside at;
      at.shape = cell.element.shape(local.x(), local.y());
      at.gradient = jacobian(at.shape, cell.body.arms).gradient;
      const double length = curve.tangent(xi).norm() / ways;  // by the xi of the way
      at.place = curve.point(xi).position();
      at.normal = curve.normal(xi);
      at.rise = bulge.rise[k] * (1 - gauss.xi * gauss.xi);
      at.way = at.rise * at.normal;
      at.curvature = 2 * bulge.rise[k] / (length * length);
      at.number = k;
      at.angle = 4 * bulge.rise[k] / length;
      const double slope = 2 * gauss.xi * bulge.rise[k] / length;
      const Depth& depth = cell.body.depth;
      at.area = gauss.weight * length * depth.at(at.place.x());
      at.area_on_curve =
          gauss.weight * length * std::hypot(1.0, slope) * depth.at(at.place.x() + at.way.x());
      places.push_back(at);
    }
  return places;
}

}  // namespace signorini

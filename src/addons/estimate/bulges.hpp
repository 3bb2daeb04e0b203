// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Where the curve that an outline follows leaves the sides of cells, and by how much.
#pragma once
#include <Eigen/Core>
#include <map>
#include <vector>

#include "signorini/fem/cells.hpp"

namespace signorini {

/// A side that the outline leaves between its nodes, see OutlineShape.
struct Bulge {
  CellSide side;  ///< of a cell
  std::vector<double>
      rise;  ///< in the middle of each way between nodes, out of the body > 0 [length]
};

/// \param mesh  any
/// \return the sides that the outline leaves, by number of the cell
[[nodiscard]] std::map<Eigen::Index, std::vector<Bulge>> bulges(const Mesh& mesh);

/// A place on such a side, and the place beside it on the curve.
struct Beside {
  Shape shape;             ///< functions of the cell
  CellNodes gradient;      ///< of them [1/length]
  Eigen::Vector2d place;   ///< on the side [length]
  Eigen::Vector2d way;     ///< from there to the curve [length]
  Eigen::Vector2d normal;  ///< of the side, out of the body [-]
  double rise;             ///< of the curve there, out of the body > 0 [length]
  double curvature;        ///< of the curve, > 0 where the body is convex [1/length]
  std::size_t number;      ///< of the way between neighbouring nodes that it is on
  double angle;            ///< by which the curve turns on that way [rad]
  double area;             ///< that the place stands for [length^2]
  double area_on_curve;    ///< and the place on the curve [length^2]

  /// \param nodal  a field on the nodes of the cell \return its value at the place
  [[nodiscard]] Eigen::Vector2d here(const CellNodes& nodal) const {
    return nodal.transpose() * shape.value;
  }
  /// \param nodal  a field on the nodes of the cell \return its value continued to the curve
  [[nodiscard]] Eigen::Vector2d on_curve(const CellNodes& nodal) const {
    return here(nodal) + nodal.transpose() * (gradient * way);
  }
};

/// The Gauss points of every way between neighbouring nodes of a side, over which the curve rises as a parabola.
/// \param cell   that has the side
/// \param bulge  the side
/// \return two for each way
[[nodiscard]] std::vector<Beside> places_beside(const Cell& cell, const Bulge& bulge);

}  // namespace signorini

// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// A graded core in the corner of a quarter plane with layers of cells around it.
#pragma once
#include <Eigen/Core>
#include <string>

#include "signorini/fem/mesh.hpp"

namespace signorini {

/// A core of rows and columns next to the origin, right of x = 0 and below y = 0, and layers around
/// it. Every layer ends on a line with half-axes (a, b) that is a rectangle, an ellipse, or, by the
/// map (p, q) -> (a p sqrt(1 - r q^2 / 2), b q sqrt(1 - r p^2 / 2)) of the sides of the unit square
/// with roundness r from 0 (rectangle) to 1 (ellipse), something in between.
struct QuarterGrid {
  std::string name = "quarter";  ///< what messages call it
  Eigen::VectorXd
      columns;            ///< places of the core's nodes along x / its width, from 0 to 1; corners
                          ///< on even places of the list, midpoints on odd ones [-]
  Eigen::VectorXd rows;   ///< the same in depth / its depth [-]
  Eigen::VectorXd width;  ///< half-axes a of core and layers, `layers + 1`, increasing [length]
  Eigen::VectorXd depth;  ///< half-axes b of core and layers, `layers + 1`, increasing [length]
  Eigen::VectorXd roundness;            ///< of core and layers, `layers + 1`, 0 to 1 [-]
  MeshOrder order = MeshOrder::Linear;  ///< 4 or 8 nodes per cell
};

/// Makes the cells, those of the core first.
///
/// Boundaries, once round counter-clockwise: `axis` (x = 0, downwards), `base` (outermost line
/// below the diagonal), `side` (outermost line beside it), `surface` (y = 0, to the left). Nodes on
/// axis, surface and a straight base or side have their coordinate exactly.
/// \param grid  increasing places, and half-axes and roundness of equal number
/// \return a mesh; not checked, see check_mesh()
[[nodiscard]] Mesh make_quarter_grid(const QuarterGrid& grid);

/// Half-axes of layers that grow by factors.
/// \param core     half-axis of the core, positive [length]
/// \param far      half-axis of the outermost layer, above that of the core [length]
/// \param layers   at least 1
/// \param grading  growth of the last layer / growth of the first, of logarithms, positive; 1:
///   every layer ends at the same multiple of where it begins [-]
/// \return `layers + 1` half-axes; the first and the last are exact
[[nodiscard]] Eigen::VectorXd growing_layers(double core, double far, Eigen::Index layers,
                                             double grading);

}  // namespace signorini

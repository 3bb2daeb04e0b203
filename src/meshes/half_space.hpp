/// \file
/// The right half of a rectangle that stands for a half-space under a load, fine where the load is.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>

#include "meshes/block.hpp"

namespace signorini {

/// A rectangle 0 <= x <= width, -depth <= y <= 0, fine next to the origin: a core of even cells in
/// the corner and layers around it that grow by equal factors, so that they are few however far it
/// goes.
struct HalfSpaceSpec {
  std::string name = "half-space";                 ///< what messages call it
  double width = 40;                               ///< [length], beyond the core
  double depth = 40;                               ///< [length], beyond the core
  Eigen::Vector2d core = Eigen::Vector2d::Ones();  ///< width and depth of the core [length]
  Eigen::Index core_columns = 8;                   ///< cells of the core along the surface
  Eigen::Index core_rows = 8;                      ///< cells of the core in depth
  Eigen::Index layers = 10;                        ///< of cells around the core, at least 1
  double layer_grading = 1;  ///< growth of the last layer / of the first, in logarithms [-]
  MeshOrder order = MeshOrder::Linear;  ///< 4 or 8 nodes per cell
};

/// Divides a rectangle that is fine at a point of its surface, the origin.
///
/// Boundaries, counter-clockwise: `axis` (x = 0, downwards), `base` (y = -depth), `side` (x =
/// width), `surface` (y = 0, to the left). Coordinates on them are exact. Further places by
/// moved().
/// \param spec  the rectangle
/// \return a mesh; check_mesh() finds 8-node cells that are bent too far, as where a core of one
///   column ends in layers that grow in depth only
/// \throws std::invalid_argument naming the number that is out of range
[[nodiscard]] Mesh make_half_space(const HalfSpaceSpec& spec);

/// A rectangle 0 <= x <= width, -depth <= y <= 0, fine below the edge of a load on 0 <= x <= edge.
struct EdgeBlockSpec {
  std::string name = "soil";      ///< what messages call it
  double edge = 1;                ///< where the load ends [length]
  double width = 10;              ///< [length], beyond the edge
  double depth = 10;              ///< [length]
  Eigen::Index cells_under = 8;   ///< under the load, at least 1
  Eigen::Index cells_beside = 8;  ///< from the edge to the side, at least 2
  Eigen::Index cells_deep = 8;    ///< from the surface to the base, at least 2
  double grading_under = 4;       ///< cell at the axis / cell at the edge, positive [-]
  std::optional<double> grading_beside =
      {};                                   ///< cell at the side / cell at the edge; if empty, the
                                            ///< first is as wide as the last under the load [-]
  std::optional<double> grading_deep = {};  ///< cell at the base / cell at the surface; if empty,
                                            ///< the first is as high as that cell is wide [-]
  MeshOrder order = MeshOrder::Linear;      ///< 4 or 8 nodes per cell

  /// \return number of nodes of the mesh; of 4-node cells
  ///   `(cells_under + cells_beside + 1)(cells_deep + 1)`
  [[nodiscard]] Eigen::Index n_nodes() const;
  /// \return positions of the nodes under the load, from 0 to `edge` [length]: for the body above
  /// \throws std::invalid_argument naming the number that is out of range
  [[nodiscard]] Eigen::VectorXd under() const;
};

/// Divides a rectangle that is fine at an edge, by lines across its whole width and depth.
///
/// Boundaries, counter-clockwise: `axis` (x = 0, downwards), `base`, `side`, `surface` (y = 0, to
/// the left); `loaded` is the part of the surface with x <= edge.
/// \param spec  the rectangle
/// \return a mesh that passes check_mesh()
/// \throws std::invalid_argument naming the number that is out of range
[[nodiscard]] Mesh make_edge_block(const EdgeBlockSpec& spec);

}  // namespace signorini

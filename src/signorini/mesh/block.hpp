/// \file
/// Rectangular blocks of quadrilaterals, graded in both directions.
#pragma once
#include <Eigen/Core>
#include <functional>

#include "signorini/mesh/mesh.hpp"

namespace signorini {

/// Nodes per cell side.
enum class MeshOrder {
  Linear,    ///< cells of 4 nodes
  Quadratic  ///< cells of 8 nodes
};

/// A rectangle and how it is divided.
struct BlockSpec {
  std::string name = "block";                        ///< what messages call it
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();  ///< lower left corner [length]
  Eigen::Vector2d size = Eigen::Vector2d::Ones();    ///< width and height [length]
  Eigen::Index cells_x = 1;                          ///< cells along x
  Eigen::Index cells_y = 1;                          ///< cells along y
  double grading_x =
      1;  ///< width of the last (right) cell over the first; sizes form a geometric row
  double grading_y = 1;  ///< height of the last (top) cell over the first
  MeshOrder order = MeshOrder::Linear;
};

/// Divides a rectangle into cells, row by row from the lower left corner, numbered along x first.
///
/// The boundaries `left`, `right`, `bottom` and `top` run counter-clockwise: bottom to the right, right
/// upwards, top to the left, left downwards.
/// \throws std::invalid_argument unless sizes, counts and gradings are positive and finite
[[nodiscard]] Mesh make_block(const BlockSpec& spec);

/// `n + 1` positions from 0 to 1 whose steps grow geometrically, last step / first step = `grading`.
[[nodiscard]] Eigen::VectorXd graded_steps(Eigen::Index n, double grading);

/// The mesh with every node moved to `map(position)`; the result is not checked.
[[nodiscard]] Mesh mapped(Mesh mesh,
                          const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& map);

}  // namespace signorini

/// \file
/// Rectangular blocks of quadrilaterals, graded in both directions.
#pragma once
#include <Eigen/Core>
#include <functional>

#include "signorini/mesh/mesh.hpp"

namespace signorini {

/// Nodes per cell side.
enum class MeshOrder {
  Linear,    ///< 2: cells of 4 nodes
  Quadratic  ///< 3: cells of 8 nodes
};

/// A rectangle and how it is divided.
struct BlockSpec {
  std::string name = "block";                        ///< what messages call it
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();  ///< lower left corner [length]
  Eigen::Vector2d size = Eigen::Vector2d::Ones();    ///< width and height [length], positive
  Eigen::Index cells_x = 1;                          ///< cells along x, at least 1
  Eigen::Index cells_y = 1;                          ///< cells along y, at least 1
  double grading_x = 1;  ///< last (right) cell width / first, positive; geometric in between [-]
  double grading_y = 1;  ///< last (top) cell height / first, positive; geometric in between [-]
  MeshOrder order = MeshOrder::Linear;  ///< 4 or 8 nodes per cell
};

/// Divides a rectangle into cells, row by row from the lower left corner, numbered along x first.
///
/// The boundaries `left`, `right`, `bottom` and `top` run counter-clockwise: bottom to the right,
/// right upwards, top to the left, left downwards.
/// \param spec  the rectangle
/// \return a mesh that passes check_mesh() unless cells are thinner than rounding of the positions
/// \throws std::invalid_argument unless sizes, counts and gradings are positive and finite
[[nodiscard]] Mesh make_block(const BlockSpec& spec);

/// Positions whose distances grow geometrically.
/// \param n        number of steps, at least 1
/// \param grading  last step / first step [-], positive
/// \return `n + 1` numbers from 0 to 1 [-]
/// \throws std::invalid_argument if `n` or `grading` is out of range
[[nodiscard]] Eigen::VectorXd graded_steps(Eigen::Index n, double grading);

/// Bends a mesh into another shape.
/// \param mesh  to start from
/// \param map   new position of a node from its position [length]
/// \return the same cells and boundaries with every node moved; not checked, see check_mesh()
[[nodiscard]] Mesh mapped(Mesh mesh,
                          const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& map);

}  // namespace signorini

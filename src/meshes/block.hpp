/// \file
/// Rectangular blocks of quadrilaterals, graded in both directions.
///
/// The mesh of most chapters is a block, or a few blocks bent and glued (reshape.hpp). How fine it
/// is, and where, is said by numbers of cells and by gradings, so that a study of convergence
/// changes two numbers.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "meshes/reshape.hpp"
#include "signorini/fem/mesh.hpp"

namespace signorini {

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

/// A rectangle of equal cells, as make_block() makes it.
/// \param name     what messages call it
/// \param corner   lower left corner [length]
/// \param size     width and height [length], positive
/// \param cells_x  cells along x, at least 1
/// \param cells_y  cells along y, at least 1
/// \param order    4 or 8 nodes per cell
/// \return a mesh, as make_block()
/// \throws std::invalid_argument as make_block()
[[nodiscard]] Mesh block(const std::string& name, const Eigen::Vector2d& corner,
                         const Eigen::Vector2d& size, Eigen::Index cells_x, Eigen::Index cells_y,
                         MeshOrder order = MeshOrder::Linear);

/// Positions whose distances grow geometrically.
/// \param n        number of steps, at least 1
/// \param grading  last step / first step [-], positive
/// \return `n + 1` numbers from 0 to 1 [-]
/// \throws std::invalid_argument if `n` or `grading` is out of range
[[nodiscard]] Eigen::VectorXd graded_steps(Eigen::Index n, double grading);

/// A part of a line and how it is divided.
struct Stretch {
  double end = 1;          ///< where it ends; it begins where the one before it ended [length]
  Eigen::Index cells = 1;  ///< at least 1
  double grading = 1;      ///< last cell / first cell, positive; geometric in between [-]
};

/// Positions along a line of several parts.
/// \param start      where the first part begins [length]
/// \param stretches  parts one after the other, at least one, each ending beyond the one before
/// \return increasing positions: `start`, and one more for every cell; ends of parts are exact
/// \throws std::invalid_argument naming the stretch (counted from 0) that has no length, no cell or
///   no positive grading
[[nodiscard]] Eigen::VectorXd stretched(double start, const std::vector<Stretch>& stretches);

/// The grading with which a part of a line begins with a cell of given length.
/// \param length  of the part, positive [length]
/// \param cells   at least 2
/// \param first   length of the first cell, below `length` [length]
/// \return last cell / first cell [-]
/// \throws std::invalid_argument if a number is out of range
[[nodiscard]] double grading_from(double length, Eigen::Index cells, double first);

/// Divides a rectangle along given lines. Cells and boundaries are those of make_block().
/// \param name   what messages call it
/// \param x      positions of the upright lines, increasing, at least 2 [length]
/// \param y      positions of the level lines, increasing, at least 2 [length]
/// \param order  4 or 8 nodes per cell; 8: midpoints lie half way
/// \return a mesh that passes check_mesh() unless cells are thinner than rounding of the positions
/// \throws std::invalid_argument naming the first pair of lines that does not increase
[[nodiscard]] Mesh make_graded_block(const std::string& name, const Eigen::VectorXd& x,
                                     const Eigen::VectorXd& y, MeshOrder order = MeshOrder::Linear);

}  // namespace signorini

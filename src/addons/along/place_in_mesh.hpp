// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Which cell of a mesh holds a point, and how its nodes share it.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/fem/element.hpp"
#include "signorini/fem/mesh.hpp"

namespace signorini {

/// A point as its nodes have it.
struct PlaceInMesh {
  std::vector<Eigen::Index> nodes;  ///< of the cell that holds it
  Eigen::VectorXd share;  ///< of each of them: the shape functions there, which add up to 1 [-]
  double
      outside;  ///< how far it is beyond the sides of the cell, whose reference cell is 1 or 2 wide [-]; 0 within
};

/// Finds a point. Where cells meet, the first that holds it is taken: displacements are the same there in all of them.
/// \param mesh     of a body
/// \param element  of its cells
/// \param point    [length]
/// \return the cell that holds the point, or else the one that it is beyond by the least
/// \throws ProblemError that names the nearest node if no cell is near
[[nodiscard]] PlaceInMesh place_in_mesh(const Mesh& mesh, const Element& element,
                                        const Eigen::Vector2d& point);

/// The same, for a point that must be in the body.
/// \param mesh     of a body
/// \param element  of its cells
/// \param point    [length]
/// \return as place_in_mesh()
/// \throws ProblemError that names the nearest node if the point is outside by more than rounding, 1e-6 of a cell
[[nodiscard]] PlaceInMesh place_within(const Mesh& mesh, const Element& element,
                                       const Eigen::Vector2d& point);

/// Points that a body does not have, as a line through a hole has some.
/// \param mesh     of a body
/// \param element  of its cells
/// \param points   `n x 2` [length]
/// \return rows of those that place_within() refuses, in increasing order
[[nodiscard]] std::vector<Eigen::Index> points_outside(const Mesh& mesh, const Element& element,
                                                       const NodeArray& points);

}  // namespace signorini

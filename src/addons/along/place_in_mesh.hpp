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
/// \return the cell that holds the point, or else the one that it is beyond by the least; no nodes, and infinitely far outside, if no cell
///   is near
[[nodiscard]] PlaceInMesh place_in_mesh(const Mesh& mesh, const Element& element,
                                        const Eigen::Vector2d& point);

/// \param place  from place_in_mesh()
/// \return whether its point is outside of the body by more than rounding, 1e-6 of a cell: beyond it, or in a hole
[[nodiscard]] bool is_outside(const PlaceInMesh& place);

/// The same, for a point that must be in the body.
/// \param mesh     of a body
/// \param element  of its cells
/// \param point    [length]
/// \return as place_in_mesh()
/// \throws ProblemError that names the nearest node if the point is outside by more than rounding, 1e-6 of a cell
[[nodiscard]] PlaceInMesh place_within(const Mesh& mesh, const Element& element,
                                       const Eigen::Vector2d& point);

}  // namespace signorini

/// \file
/// Meshes of triangles, and mixed ones, from meshes of quadrilaterals.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/fem/mesh.hpp"

namespace signorini {

/// Cuts quadrilaterals into two triangles each, along the shorter diagonal; of two equal ones, along that from
/// the first corner of the cell. In quadratic cells the diagonal gets a node in its middle, and is straight
/// if the sides of the cell are.
/// \param mesh   any
/// \param cells  numbers of those to be cut; triangles stay as they are
/// \return the same body with the same boundaries and regions; new nodes follow the old ones, and the two
///   pieces of a cell take its place
/// \throws std::invalid_argument if there is no cell of such a number
[[nodiscard]] Mesh split(const Mesh& mesh, const std::vector<Eigen::Index>& cells);

/// Cuts all quadrilaterals.
/// \param mesh  any
/// \return a mesh of triangles of 3 or 6 nodes
[[nodiscard]] Mesh split(const Mesh& mesh);

}  // namespace signorini

/// \file
/// Parts of a body by name.
///
/// Boundaries name sides, regions name cells: the concrete and the rock of one mesh.
#pragma once
#include <string>
#include <vector>

#include "signorini/fem/mesh.hpp"

namespace signorini {

/// Looks up a region.
/// \param mesh  that has it
/// \param name  of the region
/// \return numbers of its cells
/// \throws ProblemError if there is no such region, with those that exist, or it has no cells or one that is not
[[nodiscard]] const std::vector<Eigen::Index>& region(const Mesh& mesh, const std::string& name);

/// Makes a region of the cells whose middle, the mean of the corners, lies in a rectangle.
/// \param mesh  to start from
/// \param name  of the region; one of that name is replaced
/// \param low   lower left corner of the rectangle [length]
/// \param high  upper right corner [length]; infinity is allowed in both
/// \return the mesh with the region
/// \throws ProblemError if there is no such cell
[[nodiscard]] Mesh with_region(Mesh mesh, const std::string& name, const Eigen::Vector2d& low,
                               const Eigen::Vector2d& high);

}  // namespace signorini

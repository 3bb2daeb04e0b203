/// \file
/// Cells between an inner and an outer line, for the generators of plates with a hole and of rings.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "signorini/mesh/block.hpp"
#include "signorini/mesh/mesh.hpp"

namespace signorini {

/// How much of a body around a hole is meshed, counter-clockwise from the positive x axis.
enum class Sector {
  Quarter,  ///< x and y not below the centre: two lines of symmetry
  Half,     ///< y not below the centre: one line of symmetry
  Full      ///< all the way round
};

/// \param sector  of a body around a hole
/// \return the angle it spans [rad]
[[nodiscard]] double opening(Sector sector);

/// Directions of the rays from the centre and between them.
/// \param rays    what the user gave: directions [rad], or none
/// \param cells   number of cells along the angle
/// \param sector  that they fill
/// \return `2 cells + 1` directions [rad]: the rays, even ones if none were given, and their
///   bisectors
/// \throws std::invalid_argument unless there are `cells + 1` rays that increase from 0 to
///   opening(), each less than half a turn from the next
[[nodiscard]] Eigen::VectorXd ray_directions(const Eigen::VectorXd& rays, Eigen::Index cells,
                                             Sector sector);

/// Rays that divide each quadrant evenly, counter-clockwise from the positive x axis.
/// \param cells  number of cells in each of one, two or four quadrants, at least 1
/// \return one direction more than cells [rad]
/// \throws std::invalid_argument if a quadrant has no cell or their number fits no sector
[[nodiscard]] Eigen::VectorXd rays_by_quadrant(const std::vector<Eigen::Index>& cells);

/// Unit vector of a direction; exact on the axes.
/// \param angle  from the x axis [rad]
/// \return (cos, sin), with components below rounding set to 0
[[nodiscard]] Eigen::RowVector2d unit_vector(double angle);

/// Straight rays from an inner to an outer line, divided into cells, numbered along the rays first.
///
/// The boundaries, counter-clockwise with the body on the left: `start` (the first ray, outwards),
/// `outer`, `end` (the last ray, inwards), `inner`. A closed ring has no `start` and no `end`.
/// \param name    what messages call it
/// \param inner   `2 n + 1` points of the inner line, even ones on rays, odd ones between [length]
/// \param outer   `2 n + 1` points of the outer line [length]
/// \param steps   `m + 1` places of the nodes along each ray, from 0 (inner) to 1 (outer) [-]
/// \param sector  Full joins the last ray to the first
/// \param order   odd points are used by quadratic cells only
/// \return `n x m` cells
[[nodiscard]] Mesh make_ring_of_rays(const std::string& name, const NodeArray& inner,
                                     const NodeArray& outer, const Eigen::VectorXd& steps,
                                     Sector sector, MeshOrder order);

/// Quotes a boundary under its final name.
/// \param mesh  that has the boundary `from`, or has not
/// \param from  name that goes
/// \param to    name that its sides are added to
void rename_boundary(Mesh& mesh, const std::string& from, const std::string& to);

}  // namespace signorini
